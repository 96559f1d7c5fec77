#include "engine/app/budget/propose.hpp"
#include <algorithm>
#include <utility>

namespace afterglow
{
constexpr double kLeastShare = 0.05; // of the default frame: what each saves alone, all together cannot

std::size_t scaledGroup(const Curves& curves)
{
    const auto found = std::find_if(curves.groups.begin(), curves.groups.end(), [](const Group& g) { return g.effect == kScaled; });
    return std::size_t(found - curves.groups.begin());
}

Price predicted(const Curves& curves, const Choice& choice)
{
    Price sum{curves.ms, curves.error};
    double share = 1.0; // of the time, at the size that is drawn
    for (std::size_t g = 0; g < choice.size(); ++g) {
        const Price& price = curves.groups[g].options[choice[g]].price;
        sum.error += price.error;
        if (curves.groups[g].effect == kScaled)
            share = 1.0 + price.ms / curves.ms;
        else
            sum.ms += price.ms;
    }
    return {std::max(sum.ms, kLeastShare * curves.ms) * share, sum.error};
}

// What saves time that nobody needs stays, unless it is off by more than that.
static Choice kept(const Curves& curves, Choice choice, double ms)
{
    for (std::size_t& option : choice) {
        const double error = predicted(curves, choice).error;
        const std::size_t before = std::exchange(option, 0);
        const Price price = predicted(curves, choice);
        if (price.ms > ms || price.error > error + kRounding * curves.error) option = before;
    }
    return choice;
}

// A knapsack for each size that the frame may be drawn at.
Choice propose(const Curves& curves, double ms)
{
    const std::size_t scaled = scaledGroup(curves);
    const bool scalable = scaled < curves.groups.size();
    std::vector<std::vector<Price>> prices;
    for (const Group& group : curves.groups) {
        prices.emplace_back();
        for (const Option& option : group.options) prices.back().push_back(option.price);
    }
    const std::vector<Price> scales = scalable ? prices[scaled] : std::vector<Price>(1);
    std::optional<Choice> best;
    Choice least;
    for (std::size_t s = 0; s < scales.size(); ++s) {
        if (scalable) prices[scaled].assign(1, {0.0, scales[s].error});
        const auto at = [&](Choice choice) {
            if (scalable) choice[scaled] = s;
            return choice;
        };
        const double share = 1.0 + scales[s].ms / curves.ms;
        if (const auto found = chooseWithin(prices, ms / share - curves.ms))
            if (const Choice choice = at(*found); !best || predicted(curves, choice).error < predicted(curves, *best).error) best = choice;
        if (const Choice choice = at(fastest(prices)); least.empty() || predicted(curves, choice).ms < predicted(curves, least).ms)
            least = choice;
    }
    return best ? kept(curves, *best, ms) : least;
}
}
