#include "engine/app/budget/propose.hpp"
#include <algorithm>
#include <cmath>
#include <utility>

namespace afterglow
{
constexpr double kLeastShare = 0.05; // of the default frame: what each saves alone, all together cannot
constexpr double kFine = 0.01;       // steps of a scale
constexpr int kCoarse = 5;           // of them from one knapsack to the next

Choice plainChoice(const Curves& curves) { return {std::vector<std::size_t>(curves.groups.size(), 0), curves.scales.back().scale}; }

// Straight between those that were measured.
static Scale scaleAt(const Curves& curves, double scale)
{
    const auto above = std::find_if(curves.scales.begin(), curves.scales.end(), [&](const Scale& s) { return s.scale >= scale; });
    if (above == curves.scales.end()) return curves.scales.back();
    if (above == curves.scales.begin()) return *above;
    const Scale &a = *std::prev(above), &b = *above;
    const double t = (scale - a.scale) / (b.scale - a.scale);
    return {scale, std::lerp(a.share, b.share, t), std::lerp(a.error, b.error, t)};
}

// The largest first; each is told by its own number, so that equal ones are equal.
static std::vector<double> scalesOf(const Curves& curves)
{
    std::vector<double> scales;
    const int least = int(std::lround(curves.scales.front().scale / kFine)), most = int(std::lround(curves.scales.back().scale / kFine));
    for (int i = most; i >= least; --i) scales.push_back(double(i) * kFine);
    return scales;
}

Price predicted(const Curves& curves, const Choice& choice)
{
    Price sum{curves.ms, curves.error};
    for (std::size_t g = 0; g < choice.options.size(); ++g) {
        const Price& price = curves.groups[g].options[choice.options[g]].price;
        sum.ms += price.ms, sum.error += price.error;
    }
    const Scale scale = scaleAt(curves, choice.scale);
    return {std::max(sum.ms, kLeastShare * curves.ms) * scale.share, sum.error + scale.error};
}

Choice stretched(const Curves& curves, Choice choice, double ms)
{
    for (const double scale : scalesOf(curves)) {
        choice.scale = scale;
        if (predicted(curves, choice).ms <= ms) break;
    }
    return choice;
}

// What saves time that nobody needs stays, unless it is off by more than that.
static Choice kept(const Curves& curves, Choice choice, double ms)
{
    for (std::size_t& option : choice.options) {
        const double error = predicted(curves, choice).error;
        const std::size_t before = std::exchange(option, 0);
        const Price price = predicted(curves, choice);
        if (price.ms > ms || price.error > error + kRounding * curves.error) option = before;
    }
    return choice;
}

// The other way round: the least time for an error that may be so much larger.
static Choice hurried(const Curves& curves, std::vector<std::vector<Price>> prices)
{
    const Choice plain = stretched(curves, plainChoice(curves), 0.0);
    for (std::vector<Price>& group : prices)
        for (Price& price : group) std::swap(price.ms, price.error);
    const auto found = chooseWithin(prices, (kMuch * kMuch - 1.0) * predicted(curves, plain).error);
    return found ? Choice{*found, plain.scale} : plain;
}

// A knapsack for each scale, and what it leaves of the time goes into the scale.
Choice propose(const Curves& curves, double ms)
{
    std::vector<std::vector<Price>> prices;
    for (const Group& group : curves.groups) {
        prices.emplace_back();
        for (const Option& option : group.options) prices.back().push_back(option.price);
    }
    std::optional<Choice> best;
    const std::vector<double> scales = scalesOf(curves);
    for (std::size_t s = 0; s < scales.size(); s += kCoarse) {
        const auto found = chooseWithin(prices, ms / scaleAt(curves, scales[s]).share - curves.ms);
        if (!found) continue;
        const Choice choice = stretched(curves, {*found, scales[s]}, ms);
        if (!best || predicted(curves, choice).error < predicted(curves, *best).error) best = choice;
    }
    return best ? kept(curves, *best, ms) : hurried(curves, std::move(prices));
}
}
