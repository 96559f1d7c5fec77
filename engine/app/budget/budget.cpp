#include <fmt/format.h> // first: it has a member called `check`, as error.hpp has a macro

#include "engine/app/budget/budget.hpp"
#include "engine/app/budget/propose.hpp"
#include "engine/core/error.hpp"
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

namespace afterglow
{
namespace
{
constexpr int kProposals = 5; // that are drawn before the fastest is taken

Settings settingsOf(const Curves& curves, const Choice& choice, Settings settings)
{
    for (std::size_t g = 0; g < choice.size(); ++g)
        if (const Option& option = curves.groups[g].options[choice[g]]; option.choose) option.choose(settings);
    return settings;
}

double relativeError(double squared) { return std::sqrt(std::max(squared, 0.0)); }

struct Tried {
    Choice choice;
    Price price; // measured ms, predicted error
};

// What is drawn in this run; each choice once.
struct Run {
    const Sitter& sitter;
    const Curves& curves;
    std::map<Choice, double> timed = {};

    double ms(const Choice& choice)
    {
        const auto [known, isNew] = timed.try_emplace(choice);
        if (isNew) known->second = frameMs(sitter, settingsOf(curves, choice, sitter.setup.settings), kBudgetFrames);
        return known->second;
    }
};

// Draws what is proposed until it fits and nothing better is proposed, or kProposals are through.
std::optional<Tried> bestThatFits(Run& run, double most)
{
    std::optional<Tried> best;
    double off = 1.0; // measured over predicted, of the last that was drawn
    for (int i = 0; i < kProposals; ++i) {
        const Choice choice = propose(run.curves, most / off);
        if (run.timed.contains(choice)) break;
        const Price expected = predicted(run.curves, choice);
        const double ms = run.ms(choice);
        off = ms / expected.ms;
        if (ms <= most && (!best || expected.error < best->price.error)) best = Tried{choice, {ms, expected.error}};
    }
    return best;
}

// Of what is expected to be, and what was drawn before.
Tried theFastest(Run& run)
{
    const Choice choice = propose(run.curves, -std::numeric_limits<double>::infinity());
    run.ms(choice);
    const auto least =
        std::min_element(run.timed.begin(), run.timed.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    return {least->first, {least->second, predicted(run.curves, least->first).error}};
}

// Everything as it is, but for the size that is drawn: the largest that takes no longer, or the smallest.
Choice defaultsWithin(const Curves& curves, double ms)
{
    Choice choice(curves.groups.size(), 0);
    const std::size_t scaled = scaledGroup(curves);
    if (curves.ms <= ms || scaled == curves.groups.size()) return choice;
    const std::vector<Option>& scales = curves.groups[scaled].options;
    const auto slower = [](const Option& a, const Option& b) { return a.price.ms < b.price.ms; };
    std::size_t best = std::size_t(std::min_element(scales.begin(), scales.end(), slower) - scales.begin());
    for (std::size_t i = 0; i < scales.size(); ++i)
        if (curves.ms + scales[i].price.ms <= ms && scales[i].scale > scales[best].scale) best = i;
    choice[scaled] = best;
    return choice;
}
}

Fitted fitBudget(const Sitter& sitter, double milliseconds, ProgressStyle progress)
{
    const Device& device = sitter.executor.gpu.device;
    if (!(device.timestampMilliseconds > 0.0))
        throw Error(device.deviceName + " does not tell how long a pass takes: choose another by --device, or settings by hand",
                    Exit::noDevice);
    const Settings& asked = sitter.setup.settings;
    const Target& target = sitter.target;
    const Plan planned = plan(needs(target.scene(), target.bake() && target.bake()->directAll),
                              evidenceOf(target.scene(), target.bake(), asked), asked.effects);
    const Curves curves = curvesOf(sitter, optionsFor(planned, asked, device.rayQuery), progress);
    const double most = (1.0 - kMargin) * milliseconds;
    Run run{sitter, curves};
    const std::optional<Tried> fitting = bestThatFits(run, most);
    Tried taken = fitting ? *fitting : theFastest(run);
    double error = errorSquaredOf(sitter, curves.truth, settingsOf(curves, taken.choice, asked));

    // What one would do without: the frame as it is, or drawn smaller. Where the sum of prices told wrong, that is taken
    const auto takeIfBetter = [&](const Choice& choice) {
        const Price plain{run.ms(choice), predicted(curves, choice).error};
        if (plain.error < error && plain.ms <= (fitting ? most : taken.price.ms)) taken = {choice, plain}, error = plain.error;
        return plain;
    };
    const double whole = takeIfBetter(Choice(curves.groups.size(), 0)).ms;
    takeIfBetter(defaultsWithin(curves, most * curves.ms / whole));
    const Choice equal = defaultsWithin(curves, taken.price.ms * curves.ms / whole);
    const Price plain = takeIfBetter(equal);

    Fitted fitted{.budgetMs = milliseconds, .settings = settingsOf(curves, taken.choice, asked), .fits = taken.price.ms <= most};
    fitted.ms = taken.price.ms, fitted.error = relativeError(error);
    fitted.defaultMs = whole, fitted.defaultError = relativeError(curves.error);
    fitted.equalMs = plain.ms, fitted.equalError = relativeError(plain.error), fitted.skipped = curves.skipped;
    for (std::size_t g = 0; g < taken.choice.size(); ++g) {
        const Group& group = curves.groups[g];
        if (group.effect == kScaled) fitted.equalScale = group.options[equal[g]].scale;
        if (taken.choice[g] > 0) fitted.gaveUp.push_back(group.effect + ": " + group.options[taken.choice[g]].name);
    }
    return fitted;
}

void tellGivenUp(Plan& plan, const Settings& asked, const Fitted& fitted)
{
    for (PlannedEffect& effect : plan.effects)
        if (!effect.on && fitted.settings.effects.forced.contains(effect.effect) && !asked.effects.forced.contains(effect.effect))
            effect.reason = fmt::format("given up for a frame of {:g} ms", fitted.budgetMs);
}

std::vector<std::string> spoken(const Fitted& f)
{
    const auto percent = [](double error) { return fmt::format("{:.3g} %", 100.0 * error); };
    std::vector<std::string> lines;
    lines.push_back(
        f.fits ? fmt::format("a frame at rest takes {:.3g} ms, the median of {}: within {:g} ms and its margin of {:g} %", f.ms,
                             kBudgetFrames, f.budgetMs, 100.0 * kMargin)
               : fmt::format("nothing here fits {:g} ms with its margin of {:g} %: the fastest frame is drawn, which takes {:.3g} ms",
                             f.budgetMs, 100.0 * kMargin, f.ms));
    lines.push_back(
        fmt::format("its error is {} in motion; with nothing given up {} in {:.3g} ms, and {} where that is drawn at {:.3g} of the "
                    "size, in {:.3g} ms",
                    percent(f.error), percent(f.defaultError), f.defaultMs, percent(f.equalError), f.equalScale, f.equalMs));
    if (f.gaveUp.empty()) lines.push_back("nothing is given up");
    for (const std::string& line : f.gaveUp) lines.push_back(line);
    if (f.skipped > 0) lines.push_back(fmt::format("{} options were left unmeasured, for want of time", f.skipped));
    return lines;
}

nlohmann::json jsonOf(const Fitted& f)
{
    return {{"ms", f.budgetMs},
            {"margin", kMargin},
            {"frames", kBudgetFrames},
            {"fits", f.fits},
            {"frame_ms", f.ms},
            {"error", f.error},
            {"default", {{"ms", f.defaultMs}, {"error", f.defaultError}}},
            {"equal_time", {{"render_scale", f.equalScale}, {"ms", f.equalMs}, {"error", f.equalError}}},
            {"gave_up", f.gaveUp},
            {"skipped", f.skipped}};
}
}
