#include <fmt/format.h> // first: it has a member called `check`, as error.hpp has a macro

#include "engine/app/budget/budget.hpp"
#include "engine/core/error.hpp"
#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

namespace afterglow
{
namespace
{
Settings settingsOf(const Curves& curves, const Choice& choice, Settings settings)
{
    for (std::size_t g = 0; g < choice.options.size(); ++g)
        if (const Option& option = curves.groups[g].options[choice.options[g]]; option.choose) option.choose(settings);
    settings.renderScale *= float(choice.scale);
    return settings;
}

double relativeError(double squared) { return std::sqrt(std::max(squared, 0.0)); }

std::string scaleInWords(double scale) { return fmt::format("render scale {:.2g} instead of 1", scale); }

// Draws what the search asks for.
Found searched(const Sitter& sitter, const Curves& curves, double most, ProgressStyle style)
{
    Progress progress(style);
    progress.begin("trials", kMostTrials, "frames");
    std::optional<Choice> made;
    std::optional<Stage> stage; // of the last choice: both looks need one
    const auto stageFor = [&](const Choice& choice) -> Stage& {
        if (made != choice) stage.emplace(stageOf(sitter, settingsOf(curves, choice, sitter.settings))), made = choice;
        return *stage;
    };
    Trials trials;
    trials.ms = [&](const Choice& choice) {
        progress.advance(1);
        return timed(sitter, stageFor(choice), settingsOf(curves, choice, sitter.settings), kBudgetFrames).medianMs;
    };
    trials.error = [&](const Choice& choice) {
        return judged(sitter, stageFor(choice), settingsOf(curves, choice, sitter.settings), curves.truth).error;
    };
    const Found found = search(curves, most, trials);
    progress.end();
    return found;
}
}

Fitted fitBudget(Sitter sitter, double milliseconds, ProgressStyle progress)
{
    const auto began = std::chrono::steady_clock::now();
    const Device& device = sitter.executor.gpu.device;
    if (!(device.timestampMilliseconds > 0.0))
        throw Error(device.deviceName + " does not tell how long a pass takes: choose another by --device, or settings by hand",
                    Exit::noDevice);
    const Settings asked = sitter.settings;
    sitter.settings.layers = false;
    const Target& target = sitter.target;
    const Plan planned = plan(needs(target.scene(), target.bake() && target.bake()->directAll),
                              evidenceOf(target.scene(), target.bake(), asked), asked.effects);
    const Curves curves = curvesOf(sitter, optionsFor(planned, asked, device.rayQuery), progress);
    const auto [best, plain] = searched(sitter, curves, (1.0 - kMargin) * milliseconds, progress);

    Fitted fitted{.budgetMs = milliseconds, .settings = settingsOf(curves, best.choice, asked), .fits = best.fits};
    fitted.ms = best.seen.ms, fitted.error = relativeError(best.seen.error);
    fitted.defaultMs = curves.medianMs, fitted.defaultError = relativeError(curves.error);
    fitted.equalScale = plain.choice.scale, fitted.equalMs = plain.seen.ms, fitted.equalError = relativeError(plain.seen.error);
    fitted.unmeasured = curves.unmeasured;
    for (std::size_t g = 0; g < curves.groups.size(); ++g)
        if (const std::size_t option = best.choice.options[g]; option > 0)
            fitted.gaveUp.push_back(curves.groups[g].effect + ": " + curves.groups[g].options[option].name);
    if (best.choice.scale < 1.0) fitted.gaveUp.push_back(kScaled + (": " + scaleInWords(best.choice.scale)));
    fitted.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    return fitted;
}

void tellGivenUp(Plan& plan, const Settings& asked, const Fitted& fitted)
{
    for (PlannedEffect& effect : plan.effects)
        if (!effect.on && fitted.settings.effects.forced.contains(effect.effect) && !asked.effects.forced.contains(effect.effect))
            effect.reason = fmt::format("given up for a frame of {:g} ms", fitted.budgetMs);
}

// How the frame stands to its time.
static std::string timeInWords(const Fitted& f)
{
    const std::string takes = fmt::format("a frame at rest takes {:.3g} ms, the median of {}", f.ms, kBudgetFrames);
    const std::string margin = fmt::format("its margin of {:g} %", 100.0 * kMargin);
    if (f.fits) return fmt::format("{}: within {:g} ms and {}", takes, f.budgetMs, margin);
    if (f.ms <= f.budgetMs) return fmt::format("{}: within {:g} ms, but {} is not kept", takes, f.budgetMs, margin);
    return fmt::format("nothing here fits {:g} ms that is not much worse than the plain frame at its smallest: {}", f.budgetMs, takes);
}

std::vector<std::string> spoken(const Fitted& f)
{
    const auto percent = [](double error) { return fmt::format("{:.3g} %", 100.0 * error); };
    std::vector<std::string> lines;
    lines.push_back(timeInWords(f));
    lines.push_back(
        fmt::format("its error is {} in motion; with nothing changed {} in {:.3g} ms, and {} where that is drawn at {:.3g} of the "
                    "size, in {:.3g} ms",
                    percent(f.error), percent(f.defaultError), f.defaultMs, percent(f.equalError), f.equalScale, f.equalMs));
    if (f.gaveUp.empty()) lines.push_back("nothing is changed");
    for (const std::string& line : f.gaveUp) lines.push_back(line);
    lines.push_back(f.unmeasured > 0 ? fmt::format("found in {:.0f} s; the next run measures {} options that there was no time for",
                                                   f.seconds, f.unmeasured)
                                     : fmt::format("found in {:.0f} s", f.seconds));
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
            {"unmeasured", f.unmeasured},
            {"seconds", f.seconds}};
}
}
