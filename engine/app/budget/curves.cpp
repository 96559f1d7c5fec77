#include "engine/app/budget/curves.hpp"
#include "engine/app/budget/cache.hpp"
#include "engine/app/budget/queue.hpp"
#include <algorithm>
#include <chrono>
#include <cmath>

namespace afterglow
{
namespace
{
constexpr int kTimed = 4; // frames, for a price
constexpr double kScales[] = {0.25, 0.33, 0.5, 0.67, 0.8};

Settings scaledTo(Settings settings, double scale)
{
    settings.renderScale *= float(scale);
    return settings;
}

double pixelsOf(uvec2 size) { return double(size.x) * double(size.y); }

// Of the frame's time, by effect: of passes that bear its name, those of other eyes included.
std::map<std::string, double> sharesOf(const Look& look, const std::vector<Group>& groups)
{
    std::map<std::string, double> shares;
    for (const auto& [name, pass] : look.passes)
        for (const Group& group : groups)
            if (("." + name + ".").find("." + group.effect + ".") != std::string::npos) shares[group.effect] += pass.ms / look.ms;
    return shares;
}

std::map<std::string, double> errorsOf(const Measured& measured, const std::string& effect)
{
    std::map<std::string, double> errors = {{"", measured.error}};
    if (const auto found = measured.changes.find(effect); found != measured.changes.end())
        for (const auto& [name, change] : found->second) errors[name] = change.error;
    return errors;
}

// Measures what is not known yet, and keeps it one by one: whoever ends the program loses nothing.
struct Measuring {
    const Sitter& sitter;
    Stage& standing; // of the default
    const Truth& truth;
    const std::string key;
    Measured& measured;
    bool kept = true;

    Change change(const Option& option)
    {
        Settings settings = sitter.settings;
        option.choose(settings);
        const Judged before = judged(sitter, standing, sitter.settings, truth); // beside it: clocks drift
        if (option.staged) return changeOf(before, judged(sitter, standing, settings, truth));
        Stage own = stageOf(sitter, settings);
        return changeOf(before, judged(sitter, own, settings, truth));
    }

    void keep() { kept = kept && remember(key, measured); }

    void scales()
    {
        for (const double scale : kScales) {
            if (measured.scales.contains(scale)) continue;
            const Settings settings = scaledTo(sitter.settings, scale);
            Stage stage = stageOf(sitter, settings);
            measured.scales[scale] = judged(sitter, stage, settings, truth).error;
            keep();
        }
    }

    // Returns how many are left.
    std::size_t options(const std::vector<Group>& groups, const std::vector<Place>& queue, ProgressStyle style)
    {
        const auto began = std::chrono::steady_clock::now();
        const auto late = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count() > kLongest; };
        std::size_t left = 0;
        Progress progress(style);
        progress.begin("options", queue.size(), "options");
        for (const Place place : queue) {
            progress.advance(1);
            const Group& group = groups[place.group];
            const Option& option = group.options[place.option];
            const std::map<std::string, double> errors = errorsOf(measured, group.effect);
            if (errors.contains(option.name) || liesBetween(group, option, errors, kRounding * measured.error)) continue;
            if (late()) {
                ++left;
                continue;
            }
            measured.changes[group.effect][option.name] = change(option);
            keep();
        }
        progress.end();
        return left;
    }
};

// What each scale takes of the whole frame's time, now.
std::vector<Scale> timedScales(const Sitter& sitter, const Measured& measured, double ms)
{
    std::vector<Scale> scales;
    for (const auto& [scale, error] : measured.scales) {
        const Settings settings = scaledTo(sitter.settings, scale);
        Stage stage = stageOf(sitter, settings);
        scales.push_back({scale, timed(sitter, stage, settings, kTimed).ms / ms, error - measured.error});
    }
    scales.push_back({});
    return scales;
}
}

Curves curvesOf(const Sitter& sitter, std::vector<Group> offered, ProgressStyle style)
{
    Stage standing = stageOf(sitter, sitter.settings);
    const bool styled = standing.plan.on("toon") || standing.plan.on("outline");
    const std::string key = keyOf(sitter), sight = styled ? key : truthKeyOf(sitter);
    Curves curves;
    if (std::optional<Truth> known = recallTruth(sight)) {
        curves.truth = std::move(*known);
    } else {
        curves.truth = styled ? styledTruth(sitter, standing) : traceTruth(sitter, style);
        rememberTruth(sight, curves.truth);
    }
    const Judged small = judged(sitter, standing, sitter.settings, curves.truth);
    const Look large = timed(sitter, standing, sitter.settings, kTimed);
    Measured measured = recall(key).value_or(Measured{});
    measured.error = small.error;
    Measuring measuring{sitter, standing, curves.truth, key, measured};
    if (mayBeScaled(sitter.settings)) measuring.scales();
    curves.unmeasured = measuring.options(offered, queueOf(offered, sharesOf(large, offered)), style);

    curves.ms = large.ms, curves.error = small.error;
    curves.medianMs = large.medianMs;
    if (mayBeScaled(sitter.settings)) curves.scales = timedScales(sitter, measured, large.ms);
    const double pixels = pixelsOf(sitter.settings.size) / pixelsOf(smallSize(sitter.settings.size));
    for (const Group& group : offered) {
        Group priced{group.effect, {group.options.front()}};
        for (const Option& option : group.options)
            if (const auto found = measured.changes[group.effect].find(option.name); found != measured.changes[group.effect].end()) {
                priced.options.push_back(option);
                priced.options.back().price = {addedMs(found->second, small.look, large, pixels), found->second.error - small.error};
            }
        keepWhatPays(priced, curves.ms, curves.error);
        curves.groups.push_back(std::move(priced));
    }
    return curves;
}

void keepWhatPays(Group& group, double ms, double error)
{
    const double kLeast = 1e-6; // ms, and squared error: where a frame is as good as its truth every difference is noise
    const auto rounded = [&](double value, double whole) { return std::round(value / (kRounding * std::max(whole, kLeast))); };
    const auto place = [&](const Option& o) { return std::pair(rounded(o.price.ms, ms), rounded(o.price.error, error)); };
    std::vector<Option> sorted = group.options, kept = {group.options.front()};
    std::stable_sort(sorted.begin(), sorted.end(), [&](const Option& a, const Option& b) { return place(a) < place(b); });
    std::optional<double> best;
    for (Option& option : sorted) {
        const double off = place(option).second;
        if (best && off >= *best) continue;
        best = off;
        if (option.choose) kept.push_back(std::move(option));
    }
    group.options = std::move(kept);
}
}
