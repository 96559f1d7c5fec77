// How time grows with the triangles of a level: a ray's, with and without a tree, and a raster's. The level is made, whichever is asked
// for.
#include "engine/app/study/triangles.hpp"
#include "bench/bench.hpp"
#include "bench/child.hpp"
#include "engine/core/error.hpp"
#include "engine/gpu/gpu.hpp"
#include <nlohmann/json.hpp>
#include <optional>

namespace afterglow
{
using nlohmann::json;

// Where there is one.
static std::unique_ptr<Gpu> deviceFor(const BenchOptions& options)
{
    try {
        return std::make_unique<Gpu>(deviceOptions(options.device));
    } catch (const Error& error) {
        if (error.exit != Exit::noDevice) throw;
        return nullptr;
    }
}

static json curveOf(Gpu* gpu, const Sweep& sweep)
{
    const Curve curve = timedCurve(gpu, sweep, unheard);
    json row = {{"what", sweep.knob}, {"verdict", curve.verdict}};
    if (curve.fit) row["slope"] = curve.fit->slope;
    for (const Point& point : curve.points) {
        json entry = {{"triangles", point.value}, {"ms", point.ms}, {"spread_ms", point.spread}};
        if (!std::isnan(point.error)) entry["differ"] = point.error;
        row["points"].push_back(entry);
    }
    return row;
}

json benchTriangles(const BenchOptions& options)
{
    return inChild([&] {
        const std::unique_ptr<Gpu> gpu = deviceFor(options);
        json curves = json::array();
        for (Sweep& sweep : triangleSweeps()) {
            const bool onDevice = sweep.clock != Clock::cpuRays;
            if (onDevice && !(gpu && (gpu->device.rayQuery || !sweep.rays))) continue;
            if (options.quick) std::erase_if(sweep.values, [&](double value) { return value > sweep.quickly; });
            curves.push_back(curveOf(gpu.get(), sweep));
        }
        return json{{"curves", curves}};
    });
}
}
