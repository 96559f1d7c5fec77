// Frames of one setting, drawn and timed.
#include "engine/app/study/studio.hpp"
#include "engine/core/error.hpp"
#include "engine/core/interrupt.hpp"
#include "shaders/color.h"
#include <algorithm>

namespace afterglow
{
namespace
{
constexpr double kLeastMs = 0.5; // of a frame, where the device has no clock: it warms up for 400 frames at the most

Texture wanted(const Pictures& pictures, Seen seen)
{
    switch (seen) {
    case Seen::displayed:
        return pictures.displayed;
    case Seen::visibility:
        check(bool(pictures.layers.occlusion), "occlusion is on where it is studied");
        return pictures.layers.occlusion;
    default:
        return pictures.radiance;
    }
}

// Of the passes that bear the effect's name, those of other eyes included.
double ownMilliseconds(const FrameStats& stats, const std::string& effect)
{
    double sum = 0.0;
    for (const PassStats& pass : stats.passes)
        if (pass.name == effect || pass.name.starts_with(effect + ".")) sum += pass.milliseconds;
    return sum;
}
}

Image pictureOf(const Image& drawn, Seen seen)
{
    Image picture(drawn.width, drawn.height, seen == Seen::visibility ? 1 : 3);
    const std::size_t from = std::size_t(drawn.channels), to = std::size_t(picture.channels);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const float value = drawn.pixels[i / to * from + i % to];
        picture.pixels[i] = seen == Seen::displayed ? srgbDecode(value) : displayInput(value);
    }
    return picture;
}

Seen seenIn(const Sweep& sweep)
{
    if (sweep.held == Held::visibility) return Seen::visibility;
    return sweep.displayed ? Seen::displayed : Seen::radiance;
}

Setup drawable(Setup setup, const Sweep& sweep)
{
    if (setup.gathered == 0) setup.settings.effects.forced["antialias"] = false;
    setup.settings.layers = seenIn(sweep) == Seen::visibility;
    return setup;
}

// Gathered frames are one picture, at the last of them.
static int picturesOf(const Sitting& s) { return s.setup.gathered > 0 ? s.setup.gathered : s.frames; }

bool isOver(const Sitting& sitting) { return sitting.next >= std::max(picturesOf(sitting), sitting.frames); }

void warmUp(Sitting& sitting, double ms)
{
    sitting.warmMs += std::max(ms, kLeastMs);
    if (sitting.warmMs < Sitting::kWarmMs) sitting.next = Sitting::kFirst;
}

void sit(Executor& executor, Sitting& sitting, const Sweep& sweep)
{
    stopIfInterrupted();
    const Setup& setup = sitting.setup;
    const Settings& settings = setup.settings;
    Stage& stage = sitting.own ? *sitting.own : *sitting.stage;
    const Seen seen = seenIn(sweep);
    const bool gathers = setup.gathered > 0;
    const int i = sitting.next++;
    if (!gathers || i <= 0) forget(stage);
    if (setup.moving && i < sitting.frames) stage.shadows.drawn = false; // a still level's cost nothing after its first frame
    Graph graph;
    View view = nextView(stage, setup.truth.camera, settings);
    if (!gathers) view.frame = uint(i - Sitting::kFirst);
    const Pictures drawnNow =
        settings.mode == Mode::truth ? drawTruth(graph, stage, setup.truth.camera, settings) : drawFrame(graph, stage, view, settings);
    const Texture texture = wanted(drawnNow, seen);
    graph.output(texture);
    if (sweep.clock == Clock::frame) graph.output(drawnNow.displayed); // whoever waits for a frame waits for bloom and display
    const FrameStats stats = executor.run(graph, stage.level->set);
    if (i < 0) return warmUp(sitting, stats.milliseconds);
    Shots& shots = sitting.shots;
    if (!gathers || i == picturesOf(sitting) - 1) shots.pictures.push_back(pictureOf(executor.download(texture), seen));
    if (i >= sitting.frames) return;
    shots.frameMs.push_back(stats.milliseconds);
    shots.ms.push_back(sweep.clock == Clock::passes     ? ownMilliseconds(stats, sweep.subject)
                       : sweep.clock == Clock::gathered ? stats.milliseconds * setup.gathered
                                                        : stats.milliseconds);
}

Shots draw(Executor& executor, Stage& stage, const Setup& setup, const Sweep& sweep, int frames)
{
    Sitting sitting{setup, frames, &stage};
    while (!isOver(sitting)) sit(executor, sitting, sweep);
    return std::move(sitting.shots);
}
}
