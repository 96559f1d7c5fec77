#include <fmt/format.h> // first: it has a member called `check`, as error.hpp has a macro

#include "engine/app/study/advice.hpp"
#include "engine/app/study/law.hpp"
#include "engine/app/study/triangle_times.hpp"
#include "engine/app/study/triangles.hpp"
#include <cmath>

namespace afterglow
{
namespace
{
std::string priceOf(const Curve& curve)
{
    if (!curve.fit) return "";
    const char* whom = curve.sweep.clock == Clock::passes ? "a raster" : "a ray";
    std::string text = fmt::format("Ten times the triangles cost {} {:.2g} times the time", whom, std::pow(10.0, curve.fit->slope));
    if (curve.fit->floor > 0.0) text += fmt::format(", beside {} that none are spared", spokenTime(curve.fit->floor));
    return text + ".";
}
}

std::vector<Sweep> triangleSweeps()
{
    const std::vector<double> counts = {1e3, 3e3, 1e4, 3e4, 1e5, 3e5, 1e6};
    const Sweep sweep{.subject = "triangles", .unit = "triangles", .values = counts, .held = Held::hits, .quickly = 1e5};
    std::vector<Sweep> sweeps(4, sweep);
    sweeps[0].knob = "rays by Embree", sweeps[0].clock = Clock::cpuRays, sweeps[0].timed = byEmbree;
    sweeps[1].knob = "rays by the device", sweeps[1].clock = Clock::gpuRays, sweeps[1].timed = byDevice, sweeps[1].rays = true;
    sweeps[2].knob = "rays without a tree", sweeps[2].clock = Clock::cpuRays, sweeps[2].timed = withoutTree;
    sweeps[3].knob = "raster", sweeps[3].clock = Clock::passes, sweeps[3].timed = rasterised;
    sweeps[0].law = sweeps[1].law = {0.3, "as the depth of the tree, log n, and what of it the caches hold", /* most= */ true};
    sweeps[2].law = {1, "each is asked"};
    sweeps[3].law = {1, "each is drawn, beside what the pixels take"};
    return sweeps;
}

Curve timedCurve(Gpu* gpu, const Sweep& sweep, const Advance& advance)
{
    Curve curve;
    curve.sweep = sweep;
    std::vector<std::pair<double, double>> law;
    for (const double value : sweep.values) {
        const Timing timing = sweep.timed(gpu, value);
        const Quartiles ms = quartiles(timing.ms);
        Point point;
        point.value = timing.triangles;
        point.name = fmt::format("{:.0f}", timing.triangles);
        point.ms = ms.median, point.spread = ms.spread;
        point.error = timing.otherwise.value_or(std::nan(""));
        point.flip = std::nan("");
        if (timing.otherwise) curve.truth = fmt::format("every triangle, asked in turn by {} rays", kAsked);
        law.emplace_back(point.value, point.ms);
        curve.points.push_back(std::move(point));
        advance(1);
    }
    curve.fit = fitLaw(law, sweep.law.most ? Floor::none : Floor::some);
    curve.verdict = verdictOf(sweep.law, sweep.unit, curve.fit);
    curve.advice = priceOf(curve);
    return curve;
}
}
