// What is wrong with a mirror image that a probe stands for: a look-up of its mips times the split sum, held against path-traced
// reflections of the level, by roughness and by angle of view. Apart: what the blur is off by (the lobe of n = v = r, whatever the view,
// between mips), and what the place is off by (an image taken elsewhere, put on a box).
#include "baker/cube.hpp"
#include "baker/mirror_rays.hpp"
#include "bench/bench.hpp"
#include "bench/child.hpp"
#include "engine/core/jobs.hpp"
#include "engine/scene/origin.hpp"
#include "engine/upload/split_sum.hpp"
#include "shaders/microfacet.h"
#include <cmath>
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

namespace
{
constexpr float kRoughnesses[] = {0.0f, 0.1f, 0.2f, 0.35f, 0.5f, 0.75f, 1.0f};
constexpr float kAngles[] = {0.0f, 30.0f, 60.0f, 80.0f};  // degrees, of the view
constexpr uint kViewSeed = 0x5eedu, kPointSeed = 0x5eeeu; // points that no probe was placed for

// A point of a glossy surface, and what it mirrors where no probe says anything.
struct Point {
    vec3 position, normal, irradiance; // irradiance / pi
};

// What comes back of a white lobe, by one half of the paths: by the truth, and by the probes' sharp images in its place.
struct Half {
    vec3 truth{0.0f}, sharp{0.0f};
};

// Sums over points, of the truth and of what is off.
struct Sums {
    double truth = 0.0, off = 0.0, squares = 0.0, blur = 0.0, place = 0.0, flat = 0.0;
};

double product(vec3 a, vec3 b) { return double(a.x) * double(b.x) + double(a.y) * double(b.y) + double(a.z) * double(b.z); }

struct Level {
    const LightTransport& transport;
    const Baked& baked;
    std::vector<Point> points;
    int paths; // of a half
};

Half traced(const Level& level, const Point& point, vec3 o, vec2 alpha, uint seed)
{
    RayCount rays;
    const Tracer tracer{&level.transport, &level.transport.lights, &rays}, camera{&level.transport, &level.transport.none, &rays};
    const Frame frame = makeFrame(point.normal);
    Half half;
    for (int i = 0; i < level.paths; ++i) {
        shared::Sampler random = makeSampler(seed, uint(i));
        const vec3 h = isMirror(alpha) ? vec3(0.0f, 0.0f, 1.0f) : sampleGgxVisible(o, alpha, next2(random));
        const vec3 l = mirrorDirection(o, h);
        if (!(l.z > 0.0f)) continue;
        const float share = isMirror(alpha) ? 1.0f : ggxG2(o, l, alpha) / ggxG1(o, alpha);
        const vec3 direction = normalize(toWorld(frame, l));
        const vec3 seen = radianceSeen(camera, tracer, {point.position, direction, kRayFar}, random);
        if (!isFinite(seen)) continue;
        half.truth += share / float(level.paths) * seen;
        half.sharp +=
            share / float(level.paths) * reflectedRadiance(level.baked.reflections, point.position, direction, 0.0f, point.irradiance);
    }
    return half;
}

Sums sumsOf(const Level& level, float roughness, float degrees)
{
    const vec2 alpha = roughnessToAlpha(roughness, 0.0f);
    const float mu = std::cos(degrees * kPi / 180.0f);
    const vec2 parts = splitSum(mu, roughness);
    std::vector<Sums> each(level.points.size());
    parallelFor(level.points.size(), 0, [&](std::size_t i) {
        const Point& point = level.points[i];
        const float turn = kTwoPi * hashFloat(hash2(uint(i), kViewSeed)), s = std::sqrt(std::max(1.0f - mu * mu, 0.0f));
        const vec3 o(s * std::cos(turn), s * std::sin(turn), mu);
        const vec3 mirror = normalize(toWorld(makeFrame(point.normal), mirrorDirection(o, vec3(0.0f, 0.0f, 1.0f))));
        const vec3 axis = lobeAxis(mirror, point.normal, roughness);
        const vec3 looked =
            (parts.x + parts.y) * reflectedRadiance(level.baked.reflections, point.position, axis, roughness, point.irradiance);
        const vec3 flat = (parts.x + parts.y) * point.irradiance;
        const Half a = traced(level, point, o, alpha, hash2(uint(i), 1u)), b = traced(level, point, o, alpha, hash2(uint(i), 2u));
        // Products of what independent halves are off by: their noise has no mean
        each[i] = {product(0.5f * (a.truth + b.truth), vec3(1.0f)), product(looked - 0.5f * (a.truth + b.truth), vec3(1.0f)),
                   product(looked - a.truth, looked - b.truth),     product(looked - a.sharp, looked - b.sharp),
                   product(a.sharp - a.truth, b.sharp - b.truth),   product(flat - a.truth, flat - b.truth)};
    });
    Sums sums;
    for (const Sums& one : each) {
        sums.truth += one.truth, sums.off += one.off, sums.squares += one.squares;
        sums.blur += one.blur, sums.place += one.place, sums.flat += one.flat;
    }
    return sums;
}

json cellOf(const Level& level, float roughness, float degrees)
{
    const Sums sums = sumsOf(level, roughness, degrees);
    const double values = 3.0 * double(level.points.size());
    const auto relative = [&](double squares) {
        return sums.truth > 0.0 ? std::sqrt(std::max(squares, 0.0) / values) / (sums.truth / values) : 0.0;
    };
    return {{"roughness", roughness},          {"degrees", degrees},
            {"error", relative(sums.squares)}, {"bias", sums.truth > 0.0 ? sums.off / sums.truth : 0.0},
            {"blur", relative(sums.blur)},     {"place", relative(sums.place)},
            {"flat", relative(sums.flat)}};
}

std::vector<Point> pointsOf(const Scene& scene, const World& world, const Baked& baked, std::size_t count)
{
    std::vector<Point> points;
    std::vector<ProbePoint> asked;
    for (const MirrorRay& ray : mirrorRays(world, Solids(LightTransport(world, scene.lights)), count, kPointSeed)) {
        points.push_back({ray.from, ray.normal, vec3(0.0f)});
        asked.push_back({toLevel(ray.from, scene.origin), ray.normal});
    }
    const std::vector<PointIrradiance> light = probeBaked(baked, asked);
    for (std::size_t i = 0; i < points.size(); ++i) points[i].irradiance = light[i].value[0] * kInvPi;
    return points;
}

json measured(const Scene& scene, const BenchOptions& options)
{
    BakeOptions bake;
    bake.quality = options.quick ? Quality::draft : Quality::medium;
    bake.threads = options.threads;
    bake.directAll = true; // the truth has all light
    bake.lightmaps = bake.lods = bake.voxels = false;
    Progress silent(ProgressStyle::none);
    json told;
    const Baked baked = bakeScene(scene, bake, silent, told);
    const World world(baked.scene, Content::staticOnly);
    const LightTransport transport(world, baked.scene.lights);
    const Level level{transport, baked, pointsOf(baked.scene, world, baked, options.quick ? 128 : 512), options.quick ? 32 : 64};
    json result = {{"level", options.level.stem().string()},
                   {"probes", baked.reflections.size()},
                   {"points", level.points.size()},
                   {"paths", 2 * level.paths}};
    if (level.points.empty()) {
        result["missing"] = "no glossy surface lies in the open, so that nothing is mirrored";
        return result;
    }
    result["baked"] = told["products"]["reflections"];
    for (const float roughness : kRoughnesses)
        for (const float degrees : kAngles) result["cells"].push_back(cellOf(level, roughness, degrees));
    return result;
}
}

json benchReflections(const BenchOptions& options)
{
    return inChild([&] {
        Scene scene = loadLevel(options.level);
        json result = json::object();
        if (!scene.reflectionProbes.empty()) result["by hand"] = measured(scene, options);
        scene.reflectionProbes.clear();
        result["automatically"] = measured(scene, options);
        return result;
    });
}
}
