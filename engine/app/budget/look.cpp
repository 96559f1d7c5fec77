#include "engine/app/budget/look.hpp"
#include "baker/baker.hpp"
#include "engine/app/study/law.hpp"
#include "engine/app/study/studio.hpp"
#include "engine/core/interrupt.hpp"
#include "engine/effects/antialias/antialias.h"
#include <algorithm>
#include <cmath>

namespace afterglow
{
const int kMoving = int(kMovingFrames); // frames that a moving picture is the mean of
constexpr int kTruthPaths = 16;         // of a pixel, of each of the two truths
constexpr double kPixels = 256 * 144;   // of the small picture
constexpr int kStyledFrames = 64;       // that a style's truth is the mean of

Stage stageOf(const Sitter& sitter, const Settings& settings)
{
    return makeStage(sitter.executor.gpu, sitter.target.scene(), sitter.target.bake(), settings);
}

static PassWork workOf(const Graph& graph, const PassData& pass)
{
    PassWork work{.key = pass.key, .threads = pass.threads, .told = pass.pushed};
    for (const Access& access : pass.accesses)
        if (access.resource != kNoResource) {
            const std::vector<std::uint8_t>& uploaded = graph.resources[access.resource].data;
            work.told.insert(work.told.end(), uploaded.begin(), uploaded.end());
        }
    return work;
}

static void count(Look& seen, const Graph& graph, const FrameStats& stats)
{
    for (const PassData& pass : graph.passes)
        for (const PassStats& ran : stats.passes)
            if (ran.name == pass.name) {
                PassTime& time = seen.passes[pass.name];
                time.ms = std::min(time.ms, ran.milliseconds);
                time.work = workOf(graph, pass);
                time.work.draws = ran.draws, time.work.triangles = ran.triangles;
            }
}

Look look(const Sitter& sitter, Stage& stage, const Settings& settings, int frames, int gathered)
{
    Look seen;
    std::vector<double> ms;
    for (int i = -1; i < frames; ++i) {
        stopIfInterrupted();
        if (i <= 0) forget(stage);
        Graph graph;
        const Pictures pictures = drawFrame(graph, stage, nextView(stage, sitter.camera, settings), settings);
        graph.output(pictures.radiance);
        graph.output(pictures.displayed); // whoever waits for a frame waits for bloom and display
        const FrameStats stats = sitter.executor.run(graph, stage.level->set);
        if (i == gathered - 1) seen.picture = pictureOf(sitter.executor.download(pictures.radiance), Seen::radiance);
        if (i < 0) continue;
        if (i == 0) seen.passes.clear();
        count(seen, graph, stats);
        ms.push_back(stats.milliseconds);
    }
    for (const auto& [name, pass] : seen.passes) seen.ms += pass.ms;
    seen.medianMs = quartiles(ms).median;
    return seen;
}

uvec2 smallSize(uvec2 size)
{
    const double share = std::min(1.0, std::sqrt(kPixels / (double(size.x) * double(size.y))));
    return max(uvec2(round(vec2(size) * float(share))), 1u);
}

Judged judged(const Sitter& sitter, Stage& stage, Settings settings, const Truth& truth)
{
    settings.size = smallSize(settings.size);
    Judged result{look(sitter, stage, settings, kMoving, kMoving)};
    const double error = errorOf(result.look.picture, result.look.picture, truth, Measure::radiance);
    result.error = error * error;
    return result;
}

Look timed(const Sitter& sitter, Stage& stage, const Settings& settings, int frames)
{
    return look(sitter, stage, settings, frames, /* gathered= */ 0);
}

Truth traceTruth(const Sitter& sitter, ProgressStyle style)
{
    Progress progress(style);
    TruthOptions options{.camera = sitter.camera, .size = ivec2(smallSize(sitter.settings.size)), .samples = kTruthPaths};
    options.portalDepth = int(sitter.settings.portal.depth);
    const auto traced = [&](std::uint32_t seed) {
        options.seed = seed;
        return truth(sitter.target.scene(), options, progress);
    };
    return truthOf(traced(1), traced(2));
}

Truth styledTruth(const Sitter& sitter, Stage& stage)
{
    Settings settings = sitter.settings;
    settings.size = smallSize(settings.size);
    const Image picture = look(sitter, stage, settings, kStyledFrames, kStyledFrames).picture;
    return truthOf(picture, picture);
}
}
