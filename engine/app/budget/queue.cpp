#include "engine/app/budget/queue.hpp"
#include <algorithm>
#include <cmath>

namespace afterglow
{
constexpr double kDearer = 0.25; // of what is sure to save as much: whether it pays is not known

// How far from the default, or from the middle where that is another method: 1 at an end.
static double farness(const Option& option)
{
    const double middle = option.standing < 0 ? 0.5 * option.last : double(option.standing);
    const double off = double(option.place) - middle, most = off < 0.0 ? middle : double(option.last) - middle;
    return most > 0.0 ? std::abs(off) / most : 1.0;
}

static double worthOf(const Option& option, double share)
{
    if (option.knob.empty()) return share;
    return share * farness(option) * (option.place < option.standing ? 1.0 : kDearer);
}

std::vector<Place> queueOf(const std::vector<Group>& groups, const std::map<std::string, double>& shares)
{
    std::vector<std::pair<std::pair<bool, double>, Place>> all;
    for (std::size_t g = 0; g < groups.size(); ++g)
        for (std::size_t i = 1; i < groups[g].options.size(); ++i) {
            const Option& option = groups[g].options[i];
            const auto share = shares.find(groups[g].effect);
            all.push_back({{!option.staged, -worthOf(option, share == shares.end() ? 0.0 : share->second)}, {g, i}});
        }
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Place> queue;
    for (const auto& [rank, place] : all) queue.push_back(place);
    return queue;
}

bool liesBetween(const Group& group, const Option& option, const std::map<std::string, double>& errors, double close)
{
    if (option.knob.empty()) return false;
    std::map<int, double> known; // by place
    if (option.standing >= 0) known[option.standing] = errors.at("");
    for (const Option& other : group.options)
        if (const auto found = errors.find(other.name); other.knob == option.knob && found != errors.end())
            known[other.place] = found->second;
    const auto above = known.lower_bound(option.place);
    if (above == known.end() || above == known.begin()) return false;
    return std::abs(above->second - std::prev(above)->second) < close;
}
}
