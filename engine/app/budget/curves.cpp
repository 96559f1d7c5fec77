#include "engine/app/budget/curves.hpp"
#include "engine/app/budget/cache.hpp"
#include "engine/app/study/law.hpp"
#include "engine/effects/antialias/antialias.h"
#include <algorithm>
#include <chrono>
#include <cmath>

namespace afterglow
{
namespace
{
constexpr int kPaths = 16;              // of a pixel, of each of the two truths
constexpr double kPixels = 256 * 144;   // of the pictures whose error is measured
const int kMoving = int(kMovingFrames); // frames that a picture in motion is the mean of
constexpr int kStyledFrames = 64;       // that a style's truth is the mean of
constexpr int kTimed = 5;               // frames, for a price

uvec2 smallSize(uvec2 size)
{
    const double share = std::min(1.0, std::sqrt(kPixels / (double(size.x) * double(size.y))));
    return max(uvec2(round(vec2(size) * float(share))), 1u);
}

Setup small(const Sitter& sitter, const Settings& settings)
{
    Setup setup = sitter.setup;
    setup.settings = settings;
    setup.settings.size = smallSize(settings.size);
    setup.truth.size = ivec2(setup.settings.size);
    setup.truth.samples = kPaths;
    setup.gathered = kMoving, setup.moving = false;
    return setup;
}

const Sweep& wholeFrames()
{
    static const Sweep sweep{.held = Held::picture, .clock = Clock::frame};
    return sweep;
}

Stage stageOf(const Sitter& sitter, const Settings& settings)
{
    return makeStage(sitter.executor.gpu, sitter.target.scene(), sitter.target.bake(), settings);
}

double errorSquared(const Shots& shots, const Truth& truth)
{
    const Image& picture = shots.pictures.front();
    const double error = errorOf(picture, picture, truth, Measure::radiance);
    return error * error;
}

Truth traceTruth(const Sitter& sitter, ProgressStyle style)
{
    Progress progress(style);
    TruthOptions options = small(sitter, sitter.setup.settings).truth;
    const auto traced = [&](std::uint32_t seed) {
        options.seed = seed;
        return truth(sitter.target.scene(), options, progress);
    };
    return truthOf(traced(1), traced(2));
}

Shots smallShots(const Sitter& sitter, Stage& stage, const Settings& settings)
{
    return draw(sitter.executor, stage, small(sitter, settings), wholeFrames(), kTimed);
}

// A style is its own truth, at rest.
Truth styledTruth(const Sitter& sitter, Stage& stage)
{
    Setup setup = small(sitter, sitter.setup.settings);
    setup.gathered = kStyledFrames;
    const Image picture = draw(sitter.executor, stage, setup, wholeFrames(), 0).pictures.front();
    return truthOf(picture, picture);
}

double fullMs(const Sitter& sitter, Stage& stage, const Settings& settings, int frames)
{
    Setup setup = sitter.setup;
    setup.settings = settings;
    setup.gathered = frames, setup.moving = false;
    return quartiles(draw(sitter.executor, stage, setup, wholeFrames(), frames).frameMs).median;
}

Settings chosen(const Sitter& sitter, const Option& option)
{
    Settings settings = sitter.setup.settings;
    if (option.choose) option.choose(settings);
    return settings;
}

double median(const Shots& shots) { return quartiles(shots.frameMs).median; }

// Options being priced, while there is time.
struct Pricing {
    const Sitter& sitter;
    Curves& curves;
    Stage& standing; // of the default
    ProgressStyle style;
    std::chrono::steady_clock::time_point began = std::chrono::steady_clock::now();

    bool late(double longest) const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count() > longest; }

    // Calls price(option, its stage, its settings) for every option but the defaults until `longest`; drops the others.
    template <class Work>
    void all(const std::string& what, double longest, Work price)
    {
        std::uint64_t options = 0;
        for (const Group& group : curves.groups) options += group.options.size() - 1;
        Progress progress(style);
        progress.begin(what, options, "options");
        for (Group& group : curves.groups) {
            std::vector<Option> priced = {group.options.front()};
            for (std::size_t i = 1; i < group.options.size(); ++i, progress.advance(1)) {
                Option& option = group.options[i];
                if (late(longest)) {
                    ++curves.skipped;
                    continue;
                }
                const Settings settings = chosen(sitter, option);
                std::optional<Stage> own;
                if (!option.staged) own = stageOf(sitter, settings);
                price(option, own ? *own : standing, settings);
                priced.push_back(std::move(option));
            }
            group.options = std::move(priced);
        }
        progress.end();
    }
};

Curves measured(const Sitter& sitter, std::vector<Group> offered, ProgressStyle style)
{
    const Settings& settings = sitter.setup.settings;
    Curves curves;
    curves.groups = std::move(offered);
    Stage standing = stageOf(sitter, settings);
    const bool styled = standing.plan.on("toon") || standing.plan.on("outline");
    curves.truth = styled ? styledTruth(sitter, standing) : traceTruth(sitter, style);
    Pricing pricing{sitter, curves, standing, style};
    const Shots plain = smallShots(sitter, standing, settings);
    curves.error = errorSquared(plain, curves.truth);
    pricing.all("errors", 0.5 * kLongest, [&](Option& option, Stage& stage, const Settings& by) {
        const Shots shots = smallShots(sitter, stage, by);
        option.price = {median(shots) - median(plain), errorSquared(shots, curves.truth) - curves.error};
    });
    // What does not pay in the small picture is not timed in the large one
    for (Group& group : curves.groups) keepWhatPays(group, median(plain), curves.error);
    curves.ms = fullMs(sitter, standing, settings, kTimed);
    pricing.all("times", kLongest, [&](Option& option, Stage& stage, const Settings& by) {
        const double ms = fullMs(sitter, stage, by, kTimed), now = fullMs(sitter, standing, settings, kTimed); // clocks drift
        option.price.ms = curves.ms * (ms / now - 1.0);
    });
    for (Group& group : curves.groups) keepWhatPays(group, curves.ms, curves.error);
    return curves;
}
}

Setup setupOf(const Settings& settings, const Camera& camera)
{
    Setup setup{.settings = settings};
    setup.settings.layers = false;
    setup.truth.camera = camera;
    setup.truth.size = ivec2(settings.size);
    setup.truth.portalDepth = int(settings.portal.depth);
    return setup;
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

double errorSquaredOf(const Sitter& sitter, const Truth& truth, const Settings& settings)
{
    Stage stage = stageOf(sitter, settings);
    return errorSquared(smallShots(sitter, stage, settings), truth);
}

double frameMs(const Sitter& sitter, const Settings& settings, int frames)
{
    Stage stage = stageOf(sitter, settings);
    return fullMs(sitter, stage, settings, frames);
}

Curves curvesOf(const Sitter& sitter, std::vector<Group> offered, ProgressStyle progress)
{
    const std::string key = keyOf(sitter, offered);
    if (std::optional<Curves> known = recall(key, offered)) return std::move(*known);
    Curves curves = measured(sitter, std::move(offered), progress);
    if (curves.skipped == 0) remember(key, curves); // half a measurement would be believed for ever
    return curves;
}
}
