#include "baker/probe_accuracy.hpp"
#include "baker/solids.hpp"
#include "engine/scene/origin.hpp"
#include "shaders/random.h"
#include <algorithm>
#include <cmath>

namespace afterglow
{
static constexpr std::size_t kTries = 20;    // for a point in the open
static constexpr double kMeanOfNormal = 0.8; // mean of |x|, x normal: sqrt(2 / pi)

std::vector<ProbePoint> freePoints(const Scene& scene, std::size_t count, std::uint32_t seed)
{
    const World world(scene, Content::staticOnly);
    const Solids solids(LightTransport(world, scene.lights));
    const dvec3 lower(scene.lower), extent = dvec3(scene.upper) - lower;
    std::vector<ProbePoint> points;
    for (std::size_t i = 0; i < kTries * count && points.size() < count; i++) {
        Sampler random = makeSampler(seed, uint(i));
        const vec2 xy = next2(random);
        const dvec3 place = lower + extent * dvec3(xy.x, xy.y, next1(random));
        // Nothing less: just below a ceiling half of what is seen from inside a wall is the ceiling's front
        if (solids.shareInside(vec3(place)) == 0.0) points.push_back({toLevel(place, scene.origin), {}});
    }
    return points;
}

std::vector<bool> insideSolids(const Scene& scene, const std::vector<ProbePoint>& points)
{
    const World world(scene, Content::staticOnly);
    const Solids solids(LightTransport(world, scene.lights));
    std::vector<bool> inside;
    for (const ProbePoint& point : points) inside.push_back(solids.hold(fromLevel(point.position, scene.origin)));
    return inside;
}

LitPoints litPoints(const Scene& scene, std::vector<ProbePoint> points, int samples, std::uint32_t seed)
{
    Progress unseen(ProgressStyle::none);
    std::vector<PointIrradiance> light = probeTruth(scene, points, samples, seed, /* threads= */ 0, unseen);
    return {std::move(points), std::move(light)};
}

static double meanOf(const PointIrradiance& light)
{
    double sum = 0.0;
    for (vec3 about : light.value) sum += double(about.x) + double(about.y) + double(about.z);
    return sum / double(3 * light.value.size());
}

ProbeAccuracy accuracyOf(const Baked& baked, const LitPoints& truth)
{
    const std::vector<PointIrradiance> said = probeBaked(baked, truth.points);
    double all = 0.0;
    for (const PointIrradiance& light : truth.light) all += meanOf(light) / double(truth.light.size());
    ProbeAccuracy accuracy;
    std::vector<double> errors;
    for (std::size_t i = 0; i < said.size(); i++) {
        const double mean = meanOf(truth.light[i]);
        const bool isDark = !(mean > kDarkPoint * all);
        (isDark ? accuracy.dark : accuracy.lit)++;
        for (std::size_t side = 0; side < 6; side++)
            for (int c = 0; c < 3; c++) {
                const double off = double(said[i].value[side][c]) - double(truth.light[i].value[side][c]);
                if (isDark) {
                    if (off > accuracy.leak * all) accuracy.leak = off / all, accuracy.leakAt = truth.points[i].position;
                } else {
                    errors.push_back(std::abs(off) / mean);
                    accuracy.noise += kMeanOfNormal * double(truth.light[i].error[side][c]) / mean;
                }
            }
    }
    if (errors.empty()) return accuracy;
    std::sort(errors.begin(), errors.end());
    for (double error : errors) accuracy.mean += error / double(errors.size());
    accuracy.noise /= double(errors.size());
    accuracy.high = errors[std::min(errors.size() * 95 / 100, errors.size() - 1)];
    accuracy.worst = errors.back();
    return accuracy;
}
}
