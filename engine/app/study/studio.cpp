#include <fmt/format.h> // first: it has a member called `check`, as error.hpp has a macro

#include "engine/app/heat.hpp"
#include "engine/app/study/law.hpp"
#include "engine/app/study/studio.hpp"
#include "engine/core/error.hpp"
#include <algorithm>
#include <cmath>
#include <ctime>

namespace afterglow
{
namespace
{
constexpr std::uint32_t kSeedPoint = 303;              // independent of the truths'
constexpr int kPictureQuality = 92, kHeatQuality = 85; // of JPEG: no block is seen, and a page is a fifth of what PNG makes it

// CPU ms of whatever is done, all threads together.
template <class Work>
Image timed(Work work, double& ms)
{
    const std::clock_t began = std::clock();
    Image picture = work();
    ms = 1e3 * double(std::clock() - began) / CLOCKS_PER_SEC;
    return picture;
}

struct Taken {
    Shots shots;
    double ms = 0.0; // once, of a product or of the path tracer
    std::optional<Image> again;
};

// The frame as planned is the same whichever effect is left out beside it: one picture serves all. It is timed anew, beside the one
// without.
bool isAsPlanned(const Sweep& sweep, double value) { return sweep.knob == kDrawn && sweep.held == Held::picture && value > 0.0; }

// Frames of all settings, in rounds: the first of each, the second of each ...
std::vector<Taken> takeTurns(Studio& studio, const Sweep& sweep, const std::vector<Setup>& setups, std::optional<Stage>& kept)
{
    std::vector<Sitting> sittings;
    sittings.reserve(setups.size());
    for (std::size_t i = 0; i < setups.size(); ++i) {
        Sitting& sitting = sittings.emplace_back(Sitting{drawable(setups[i], sweep), studio.frames});
        sitting.past = std::make_unique<Executor>(studio.gpu);
        if (isAsPlanned(sweep, sweep.values[i]) && studio.planned) sitting.setup.gathered = studio.frames;
        if (sweep.staged && setups[i].gathered == 0) {
            if (!kept) kept = makeStage(studio.gpu, studio.baked.scene, &studio.baked, sitting.setup.settings);
            sitting.stage = &*kept;
        } else {
            sitting.own = makeStage(studio.gpu, studio.baked.scene, &studio.baked, sitting.setup.settings);
        }
    }
    for (bool all = false; !all;) {
        all = true;
        for (Sitting& sitting : sittings)
            if (!isOver(sitting)) sit(*sitting.past, sitting, sweep), all = false;
    }
    std::vector<Taken> taken;
    for (std::size_t i = 0; i < setups.size(); ++i) {
        taken.push_back({std::move(sittings[i].shots)});
        if (!isAsPlanned(sweep, sweep.values[i])) continue;
        if (!studio.planned) studio.planned = taken.back().shots.pictures.front();
        taken.back().shots.pictures = {*studio.planned};
    }
    return taken;
}

Taken take(Studio& studio, const Sweep& sweep, const Setup& setup, double value)
{
    Taken taken;
    if (sweep.made) {
        taken.shots.pictures.push_back(timed([&] { return sweep.made(studio, value); }, taken.ms));
    } else if (sweep.clock == Clock::truth) {
        taken.shots.pictures.push_back(timed([&] { return traced(studio, setup, sweep.bias ? kSeedA : kSeedPoint); }, taken.ms));
        if (sweep.bias) taken.again = traced(studio, setup, kSeedB);
    } else {
        taken.shots = baked(studio, sweep, setup, taken.ms);
    }
    return taken;
}

// Pictures of few paths.
bool scatters(const Studio& studio, const Sweep& sweep)
{
    return sweep.clock == Clock::truth || given(studio, sweep).settings.mode == Mode::truth;
}

std::string nameOf(const Sweep& sweep, std::size_t index, double value)
{
    if (index < sweep.names.size()) return sweep.names[index];
    return spokenValue(value);
}

// What pictures are compared with, and how they look.
struct Reference {
    Truth truth;
    Measure by;
    Exhibit exhibit;
    Image looks;
};

void rate(Point& point, const Taken& taken, const Reference& reference)
{
    double squares = 0.0, noise = 0.0; // the truth's noise is the same for all pictures: their mean has as much of it
    for (const Image& picture : taken.shots.pictures) {
        const double error = errorOf(picture, taken.again.value_or(picture), reference.truth, reference.by);
        const double floor = floorOf(picture, taken.again.value_or(picture), reference.truth, reference.by);
        squares += error * error / double(taken.shots.pictures.size());
        noise += floor * floor / double(taken.shots.pictures.size());
    }
    point.error = std::sqrt(squares), point.noise = std::sqrt(noise);
    const Quartiles ms = taken.ms > 0.0 ? quartiles({taken.ms}) : quartiles(taken.shots.ms);
    point.ms = ms.lower, point.median = ms.median, point.spread = ms.spread;
    point.frameMs = quartiles(taken.shots.frameMs).lower;
    lookAt(point, shown(taken.shots.pictures.front(), reference.exhibit), reference.looks);
}
}

Point pointOf(const Sweep& sweep, std::size_t index, double standard)
{
    Point point;
    point.value = sweep.relative ? sweep.values[index] * standard : sweep.values[index];
    point.standard = std::abs(point.value - standard) <= 1e-3 * std::abs(standard);
    point.name = nameOf(sweep, index, point.value);
    return point;
}

std::vector<std::uint8_t> jpegOf(const Image& shown) { return encodeJpeg(encodeSrgb(shown), kPictureQuality); }

void lookAt(Point& point, const Image& picture, const Image& truth)
{
    const Flip flip = flipDisplayed(picture, truth);
    point.flip = flip.mean;
    point.picture = jpegOf(picture);
    point.heat = encodeJpeg(heat(flip.map), kHeatQuality);
}

std::uint64_t stepsOf(const Sweep& sweep) { return sweep.values.size() + (sweep.held == Held::limit && !sweep.inSpace ? 1 : 0); }

Curve measure(Studio& studio, const Sweep& sweep, const Advance& advance)
{
    std::optional<Stage> kept;
    const bool radiance = seenIn(sweep) == Seen::radiance;
    const Measure measure = !radiance ? Measure::values : scatters(studio, sweep) ? Measure::samples : Measure::radiance;
    const Exhibit exhibit = radiance ? exhibitFor(studio.picture.mean, studio.standard.settings.display) : Exhibit{.values = true};
    Reference reference{{}, measure, exhibit, {}};
    const auto holdAgainst = [&](Truth truth) {
        reference.truth = std::move(truth);
        reference.looks = shown(reference.truth.mean, exhibit);
        return jpegOf(reference.looks);
    };
    Curve curve;
    curve.sweep = sweep;
    curve.truth = truthName(studio, sweep);
    if (!sweep.exact) curve.reference = holdAgainst(truthFor(studio, sweep, kept));
    if (sweep.held == Held::limit) advance(1);

    std::vector<Setup> setups;
    for (std::size_t i = 0; i < sweep.values.size(); ++i) {
        Setup& setup = setups.emplace_back(given(studio, sweep));
        curve.points.push_back(pointOf(sweep, i, sweep.turn.get(setup)));
        if (!sweep.made) sweep.turn.set(setup, curve.points.back().value);
    }
    std::vector<Taken> turns;
    if (takesTurns(sweep)) turns = takeTurns(studio, sweep, setups, kept);
    std::vector<std::pair<double, double>> law;
    for (std::size_t i = 0; i < sweep.values.size(); ++i) {
        Point& point = curve.points[i];
        if (sweep.exact) {
            const Image exact = sweep.exact(studio, point.value);
            point.reference = holdAgainst(truthOf(exact, exact));
        }
        rate(point, turns.empty() ? take(studio, sweep, setups[i], point.value) : turns[i], reference);
        if (point.value > 0.0 && point.error > point.noise) law.emplace_back(point.value, point.error);
        advance(1);
    }
    if (sweep.names.empty()) curve.fit = fitLaw(law);
    curve.verdict = verdictOf(sweep.law, sweep.knob, curve.fit);
    return curve;
}
}
