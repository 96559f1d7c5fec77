// How far irradiance probes are from the light itself, at points of free space that nobody chose.
#pragma once
#include "baker/baker.hpp"

namespace afterglow
{
// Points, and the light that meets each about +x -x +y -y +z -z, path traced.
struct LitPoints {
    std::vector<ProbePoint> points;
    std::vector<PointIrradiance> light;
};

// `count` points, evenly by chance in the box of the level's static objects, off its solids. Fewer where nearly all of it is solid.
std::vector<ProbePoint> freePoints(const Scene& scene, std::size_t count, std::uint32_t seed);

// Which points lie in solids, where nobody asks.
std::vector<bool> insideSolids(const Scene& scene, const std::vector<ProbePoint>& points);

// The light at points, `samples` paths an axis; the bake is then one of all lights (`--direct all`).
LitPoints litPoints(const Scene& scene, std::vector<ProbePoint> points, int samples, std::uint32_t seed);

// Errors are |E - truth| of each axis and channel, over the mean truth of the point's own. Where that is below kDarkPoint of the mean of
// all points a point counts as dark: it has no relative error, but it may leak.
struct ProbeAccuracy {
    double mean = 0.0, high = 0.0, worst = 0.0; // high: 95 of 100 are below
    double noise = 0.0;                         // mean error that the truth's own standard error makes
    double leak = 0.0;                          // most light where it is dark, over the mean of all points
    dvec3 leakAt{0.0};                          // m, in the level's own coordinates
    std::size_t lit = 0, dark = 0;              // points
};
constexpr double kDarkPoint = 1e-3;
ProbeAccuracy accuracyOf(const Baked& baked, const LitPoints& truth);
}
