#include "engine/app/budget/knapsack.hpp"
#include "engine/core/error.hpp"
#include <algorithm>

namespace afterglow
{
namespace
{
struct Partial {
    Price sum;
    std::vector<std::size_t> chosen;
};

// Drops what another is at least as fast and as good as; leaves the rest by rising time.
void keepFront(std::vector<Partial>& all)
{
    std::stable_sort(all.begin(), all.end(), [](const Partial& a, const Partial& b) {
        return a.sum.ms < b.sum.ms || (a.sum.ms == b.sum.ms && a.sum.error < b.sum.error);
    });
    std::vector<Partial> front;
    for (Partial& partial : all)
        if (front.empty() || partial.sum.error < front.back().sum.error) front.push_back(std::move(partial));
    all = std::move(front);
}
}

std::optional<std::vector<std::size_t>> chooseWithin(const std::vector<std::vector<Price>>& groups, double budget)
{
    std::vector<Partial> partials = {{}};
    for (const std::vector<Price>& group : groups) {
        check(!group.empty(), "a group has an option");
        std::vector<Partial> longer;
        for (const Partial& partial : partials)
            for (std::size_t i = 0; i < group.size(); ++i) {
                longer.push_back(partial);
                longer.back().sum.ms += group[i].ms, longer.back().sum.error += group[i].error;
                longer.back().chosen.push_back(i);
            }
        keepFront(longer);
        partials = std::move(longer);
    }
    const auto beyond = std::find_if(partials.begin(), partials.end(), [&](const Partial& p) { return p.sum.ms > budget; });
    if (beyond == partials.begin()) return {};
    return std::prev(beyond)->chosen; // the slowest that fits is the best that fits
}
}
