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
constexpr std::uint32_t kSeedPoint = 303, kSeedAgain = 404; // independent of each other, and of the truths'
constexpr int kPictureQuality = 92, kHeatQuality = 85;      // of JPEG: no block is seen, and a page is a fifth of what PNG makes it

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

// The frame as planned is the same whichever effect it is held against: one picture serves all. It is timed anew, beside the one without.
Shots asPlanned(Studio& studio, const Sweep& sweep, Setup setup, std::optional<Stage>& kept)
{
    double unasked = 0.0;
    if (studio.planned) setup.gathered = studio.frames;
    Shots shots = drawn(studio, sweep, setup, studio.frames, kept, unasked);
    if (!studio.planned) studio.planned = shots.pictures.front();
    shots.pictures = {*studio.planned};
    return shots;
}

Taken take(Studio& studio, const Sweep& sweep, const Setup& setup, double value, std::optional<Stage>& kept)
{
    Taken taken;
    if (sweep.made) {
        taken.shots.pictures.push_back(timed([&] { return sweep.made(studio, value); }, taken.ms));
    } else if (sweep.clock == Clock::truth) {
        taken.shots.pictures.push_back(timed([&] { return traced(studio, setup, kSeedPoint); }, taken.ms));
        if (sweep.bias) taken.again = traced(studio, setup, kSeedAgain);
    } else if (sweep.knob == kDrawn && value > 0.0) {
        taken.shots = asPlanned(studio, sweep, setup, kept);
    } else {
        taken.shots = drawn(studio, sweep, setup, studio.frames, kept, taken.ms);
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
    return fmt::format("{:.3g}", value);
}

// What pictures are compared with, and how they look.
struct Reference {
    Truth truth;
    Measure by;
    Exhibit exhibit;
    Image looks;
};

Point pointOf(const Sweep& sweep, std::size_t index, double standard)
{
    Point point;
    point.value = sweep.relative ? sweep.values[index] * standard : sweep.values[index];
    point.standard = std::abs(point.value - standard) <= 1e-3 * std::abs(standard);
    point.name = nameOf(sweep, index, point.value);
    return point;
}

void rate(Point& point, const Taken& taken, const Reference& reference)
{
    double squares = 0.0;
    for (const Image& picture : taken.shots.pictures) {
        const double error = errorOf(picture, taken.again.value_or(picture), reference.truth, reference.by);
        squares += error * error / double(taken.shots.pictures.size());
    }
    point.error = std::sqrt(squares);
    const Quartiles ms = quartiles(taken.shots.ms);
    point.ms = taken.ms > 0.0 ? taken.ms : ms.median;
    point.spread = taken.ms > 0.0 ? 0.0 : ms.spread;
    point.frameMs = quartiles(taken.shots.frameMs).median;
    const Image looks = shown(taken.shots.pictures.front(), reference.exhibit);
    const Flip flip = flipDisplayed(looks, reference.looks);
    point.flip = flip.mean;
    point.picture = encodeJpeg(encodeSrgb(looks), kPictureQuality);
    point.heat = encodeJpeg(heat(flip.map), kHeatQuality);
}
}

std::uint64_t stepsOf(const Sweep& sweep) { return sweep.values.size() + (sweep.held == Held::limit ? 1 : 0); }

Curve measure(Studio& studio, const Sweep& sweep, const Advance& advance)
{
    std::optional<Stage> kept;
    const bool radiance = seenIn(sweep) == Seen::radiance;
    const Measure measure = !radiance ? Measure::values : scatters(studio, sweep) ? Measure::samples : Measure::radiance;
    Reference reference{truthFor(studio, sweep, kept), measure, {.values = !radiance}, {}};
    if (radiance) reference.exhibit = exhibitFor(studio.picture.mean, studio.standard.settings.display);
    reference.looks = shown(reference.truth.mean, reference.exhibit);
    if (sweep.held == Held::limit) advance(1);

    Curve curve;
    curve.sweep = sweep;
    curve.truth = truthName(studio, sweep);
    curve.reference = encodeJpeg(encodeSrgb(reference.looks), kPictureQuality);
    std::vector<std::pair<double, double>> law;
    for (std::size_t i = 0; i < sweep.values.size(); ++i) {
        Setup setup = given(studio, sweep);
        Point point = pointOf(sweep, i, sweep.turn.get(setup));
        if (!sweep.made) sweep.turn.set(setup, point.value);
        rate(point, take(studio, sweep, setup, point.value, kept), reference);
        if (point.value > 0.0 && point.error > 0.0) law.emplace_back(point.value, point.error);
        curve.points.push_back(std::move(point));
        advance(1);
    }
    if (sweep.names.empty()) curve.fit = fitLaw(law);
    curve.verdict = verdictOf(sweep.law, sweep.knob, curve.fit);
    return curve;
}
}
