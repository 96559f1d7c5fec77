#include <fmt/format.h> // first: it has a member called `check`, as error.hpp has a macro

#include "baker/probes.hpp"
#include "engine/app/study/advice.hpp"
#include "engine/app/study/law.hpp"
#include "engine/app/study/probe_space.hpp"
#include "engine/app/study/studio.hpp"
#include "engine/app/study/sweeps.hpp"
#include <algorithm>
#include <cmath>

namespace afterglow
{
namespace
{
constexpr std::size_t kPoints = 512, kQuickPoints = 160;
constexpr int kPaths = 4096, kQuickPaths = 2048;  // an axis of a point
constexpr int kSliceEdge = 128, kSlicePaths = 16; // px of the longer side; paths an axis, of each of two truths
constexpr std::uint32_t kSeedPlaces = 404;
constexpr const char* kGrid = "grid spacing";

// Where the level is cut for a person to see: level, before the camera's eye.
std::vector<ProbePoint> sliceOf(const Scene& level, double height, ivec2& size)
{
    const dvec3 lower(level.lower), extent = dvec3(level.upper) - lower;
    const double pixel = std::max({extent.x, extent.z, 1e-6}) / kSliceEdge;
    size = max(ivec2(dvec2(extent.x, extent.z) / pixel), ivec2(1));
    std::vector<ProbePoint> points;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            points.push_back({dvec3(level.origin) + dvec3(lower.x + (x + 0.5) * pixel, height, lower.z + (y + 0.5) * pixel), {}});
    return points;
}

// Irradiance of each point, the mean over its six axes.
Image pictured(const Space& space, const std::vector<PointIrradiance>& light)
{
    Image picture(space.size.x, space.size.y, 3);
    for (std::size_t i = 0; i < light.size(); ++i) {
        vec3 sum(0.0f);
        for (vec3 about : light[i].value) sum += space.inside[i] ? vec3(0.0f) : about / 6.0f;
        for (int c = 0; c < 3; ++c) picture.pixels[3 * i + std::size_t(c)] = sum[c];
    }
    return picture;
}

const Space& spaceOf(Studio& studio)
{
    if (studio.space) return *studio.space;
    Space& space = studio.space.emplace();
    space.lit = litPoints(studio.level, freePoints(studio.level, studio.quick ? kQuickPoints : kPoints, kSeedPlaces),
                          studio.quick ? kQuickPaths : kPaths, kSeedA);
    const dvec3 eye(studio.camera.toWorld[3]), lower(studio.level.lower), upper(studio.level.upper);
    space.slice = sliceOf(studio.level, clamp(eye.y, lower.y, upper.y), space.size);
    space.inside = insideSolids(studio.level, space.slice);
    const auto traced = [&](std::uint32_t seed) { return pictured(space, litPoints(studio.level, space.slice, kSlicePaths, seed).light); };
    space.truth = truthOf(traced(kSeedA), traced(kSeedB));
    return space;
}

// Less of each probe than was baked.
void keep(ProbeTree& tree, Harmonics kept)
{
    if (kept == Harmonics::all) return;
    if (kept == Harmonics::order1) tree.order = 1;
    for (Probe& probe : tree.probes) {
        if (tree.order < 2) probe.irradiance = shScaleBands(probe.irradiance, 1.0f, 1.0f, 0.0f);
        probe.lobe = probe.toward = vec3(0.0f);
    }
}

// What a bake's probes say.
const SpaceTaken::Said& saidBy(Studio& studio, Setup setup, double& ms)
{
    setup.bake.directAll = true; // as the truth has it
    const auto [bake, isNew] = studio.spaceTaken.try_emplace(editionOf(setup.bake, "probes"));
    SpaceTaken& taken = bake->second;
    if (isNew) taken.probes = rebaked(studio, setup, "probes", taken.ms).probes;
    ms = taken.ms;
    const auto [known, isUnknown] = taken.said.try_emplace(setup.harmonics);
    SpaceTaken::Said& said = known->second;
    if (!isUnknown) return said;
    const Space& space = spaceOf(studio);
    Baked less = studio.baked;
    less.probes = taken.probes;
    keep(less.probes, setup.harmonics);
    said.accuracy = accuracyOf(less, space.lit);
    said.bytes = double(bytesOf(less.probes));
    said.picture = pictured(space, probeBaked(less, space.slice));
    return said;
}
const SpaceTaken::Said& saidByDefault(Studio& studio)
{
    double unasked = 0.0;
    return saidBy(studio, studio.standard, unasked);
}

// "a grid of as many bytes as the default's 31 kB errs by 12 %, 2.4 times as much", between the grids that were measured.
std::string atEqualBytes(Studio& studio, const std::vector<Point>& grids)
{
    const SpaceTaken::Said& tree = saidByDefault(studio);
    for (std::size_t i = 1; i < grids.size(); ++i) {
        const Point &a = grids[i - 1], &b = grids[i];
        if (!(a.inSpace->bytes <= tree.bytes && tree.bytes <= b.inSpace->bytes && a.inSpace->bytes < b.inSpace->bytes)) continue;
        const double t = std::log(tree.bytes / a.inSpace->bytes) / std::log(b.inSpace->bytes / a.inSpace->bytes);
        const double error = a.error * std::pow(b.error / a.error, t);
        return fmt::format("a grid of as many bytes as the default's {} errs by {:.2g} %, {:.2g} times as much", spokenBytes(tree.bytes),
                           100.0 * error, error / std::max(tree.accuracy.mean, 1e-9));
    }
    return "no grid that was measured has about as many bytes as the default";
}

Knob harmonics()
{
    return {[](const Setup& s) { return double(s.harmonics); }, [](Setup& s, double kept) { s.harmonics = Harmonics(int(kept)); }};
}

// As --probe-error asks.
Knob askedError()
{
    return {[](const Setup& s) { return double(*s.bake.probeError); },
            [](Setup& s, double error) { s.bake.probeError = float(error), s.bake.probeNoise = probeNoiseFor(float(error)); }};
}

void even(Setup& s) { s.bake.probeError = 0.0f, s.bake.probeNoise = 1e9f; } // as dense and as many paths as are said
void grid(Setup& s) { s.bake.probeError = 0.0f, s.bake.probeWalls = false; }
void few(Setup& s) { even(s), s.bake.probeSpacing = 4.0f * *s.bake.probeSpacing; }
}

std::vector<Sweep> probeSweeps()
{
    using B = BakeOptions;
    const Sweep sweep{.subject = "probes", .clock = Clock::bake, .inSpace = true};
    std::vector<Sweep> sweeps(6, sweep);
    const auto knob = [&](Sweep& s, const char* name, const char* unit, std::vector<double> values, Knob turn, Law law) {
        s.knob = name, s.unit = unit, s.values = std::move(values), s.turn = std::move(turn), s.law = law;
    };
    knob(sweeps[0], "asked error", "between them", {0.4, 0.2, 0.1, 0.05}, askedError(), {1, "as much as is asked for"});
    knob(sweeps[1], "spacing", "m", {8, 4, 2, 1}, ofBake(&B::probeSpacing), {2, "linear between them; less where light has edges"});
    knob(sweeps[2], kGrid, "m, through walls", {4, 2, 1, 0.7, 0.5, 0.25}, ofBake(&B::probeSpacing), {2, "less where light has edges"});
    knob(sweeps[3], "walls", "at even spacing", {0, 1}, ofBake(&B::probeWalls), {});
    knob(sweeps[4], "harmonics", "", {0, 1, 2}, harmonics(), {});
    knob(sweeps[5], "paths", "per probe", {0.25, 1, 4, 16}, ofBake(&B::probeSamples), {-0.5, "by lot, down to what lies between probes"});
    for (int i : {1, 2, 5}) sweeps[std::size_t(i)].relative = true;
    sweeps[1].given = sweeps[3].given = even, sweeps[2].given = grid, sweeps[5].given = few;
    sweeps[0].least = 0.1, sweeps[2].least = 0.7;
    sweeps[3].names = {"through them", "kept to"};
    sweeps[4].names = {"order 1", "order 2", "order 2 and a lobe"};
    return sweeps;
}

Curve spaceCurve(Studio& studio, const Sweep& sweep, const Advance& advance)
{
    const Space& space = spaceOf(studio);
    const Exhibit exhibit = exhibitFor(space.truth.mean, {});
    const Image looks = shown(space.truth.mean, exhibit);
    Curve curve;
    curve.sweep = sweep;
    curve.truth = fmt::format("path-traced light about six axes at {} points of free space, {} paths each (their noise {:.2g} %)",
                              space.lit.points.size(), studio.quick ? kQuickPaths : kPaths, 100.0 * saidByDefault(studio).accuracy.noise);
    curve.reference = jpegOf(looks);
    std::vector<std::pair<double, double>> law;
    for (std::size_t i = 0; i < sweep.values.size(); ++i) {
        Setup setup = given(studio, sweep);
        Point& point = curve.points.emplace_back(pointOf(sweep, i, sweep.turn.get(setup)));
        sweep.turn.set(setup, point.value);
        const SpaceTaken::Said& said = saidBy(studio, setup, point.ms);
        point.median = point.ms;
        point.error = said.accuracy.mean, point.noise = said.accuracy.noise;
        point.inSpace = {said.accuracy.high, said.accuracy.worst, said.accuracy.dark > 0 ? said.accuracy.leak : std::nan(""), said.bytes};
        lookAt(point, shown(said.picture, exhibit), looks);
        if (point.value > 0.0 && point.error > point.noise) law.emplace_back(point.value, point.error);
        advance(1);
    }
    if (sweep.names.empty()) curve.fit = fitLaw(law);
    curve.verdict = verdictOf(sweep.law, sweep.knob, curve.fit);
    if (sweep.knob == kGrid) curve.verdict = fmt::format("{}; {}", curve.verdict, atEqualBytes(studio, curve.points));
    return curve;
}
}
