#include "engine/app/study/triangle_times.hpp"
#include "baker/ray_kinds.hpp"
#include "engine/app/study/clutter.hpp"
#include "engine/app/study/studio.hpp"
#include "engine/core/jobs.hpp"
#include "engine/upload/scene_set.hpp"
#include "shaders/ray_scene.h"
#include "shaders/triangle.h"
#include <cmath>
#include <cstring>
#include <ctime>

namespace afterglow
{
namespace
{
constexpr std::size_t kRays = 131072;        // of a tree on the CPU
constexpr std::size_t kFewest = 8192;        // of a tree on the device, and four times as many until it takes
constexpr double kLongEnough = 20.0;         // ms
constexpr int kRepetitions = 5, kTurns = 11; // of the CPU; of the device, whose clock is the wall's on some
constexpr float kSame = 1e-5f;               // of the distance, between two roundings of one hit
const uvec2 kPicture{64, 36};                // so small that it is triangles, not pixels, that take the time

// The level with its rays.
struct Crowd {
    Scene scene;
    World world{scene, Content::everything};
    std::vector<Ray> rays = RayKinds(LightTransport(world, {})).incoherent(kRays);
    explicit Crowd(double triangles) : scene(clutter(std::size_t(triangles))) {}
};

// CPU ms of each repetition, on one thread, after one that warms up.
std::vector<double> cpuTimes(const std::function<void()>& work)
{
    std::vector<double> ms;
    for (int i = -1; i < kRepetitions; ++i) {
        const std::clock_t began = std::clock();
        parallelFor(1, 1, [&](std::size_t) { work(); });
        if (i >= 0) ms.push_back(1e3 * double(std::clock() - began) / CLOCKS_PER_SEC);
    }
    return ms;
}

std::vector<double> ofAMillion(std::vector<double> ms, std::size_t rays)
{
    for (double& time : ms) time *= 1e6 / double(rays);
    return ms;
}

// Distances to what the first rays meet.
struct EveryTriangle {
    std::vector<vec3> corners;
    std::vector<float> met = std::vector<float>(kAsked);

    explicit EveryTriangle(const World& world)
    {
        for (const World::Triangle& triangle : world.triangles())
            for (uint vertex : triangle.vertex) corners.push_back(world.vertices()[vertex].position);
    }
    void ask(const std::vector<Ray>& rays)
    {
        for (std::size_t r = 0; r < kAsked; ++r) {
            met[r] = kRayFar;
            for (std::size_t i = 0; i < corners.size(); i += 3)
                met[r] = std::min(met[r], triangleDistance(rays[r], corners[i], corners[i + 1], corners[i + 2]));
        }
    }
};

// The share of rays that meet something else than every triangle, asked in turn, says.
double otherwise(const Crowd& crowd, const std::vector<float>& distances)
{
    EveryTriangle truth(crowd.world);
    truth.ask(crowd.rays);
    std::size_t differ = 0;
    for (std::size_t r = 0; r < kAsked; ++r) differ += !(std::abs(distances[r] - truth.met[r]) <= kSame * truth.met[r]);
    return double(differ) / double(kAsked);
}
}

Timing byEmbree(Gpu*, double triangles)
{
    const Crowd crowd(triangles);
    std::vector<float> distances(kRays);
    const std::vector<double> ms = cpuTimes([&] {
        for (std::size_t r = 0; r < kRays; ++r) distances[r] = crowd.world.closestHit(crowd.rays[r]).distance;
    });
    return {double(crowd.world.triangles().size()), ofAMillion(ms, kRays), otherwise(crowd, distances)};
}

Timing byDevice(Gpu* gpu, double triangles)
{
    const Crowd crowd(triangles);
    GpuScene uploaded = uploadScene(*gpu, crowd.scene, instances(crowd.scene), {});
    uploaded.rays = buildRays(*gpu, crowd.scene, instances(crowd.scene));
    const GpuLevel level(*gpu, std::move(uploaded), {});
    Executor executor(*gpu);
    std::vector<Hit> hits;
    const auto trace = [&](std::size_t count) {
        Graph graph;
        const Buffer answers = graph.buffer("hits", count * sizeof(Hit));
        graph.compute("nearest", "engine/app/study/nearest.comp")
            .read(graph.upload("rays", std::span<const Ray>(crowd.rays.data(), count)))
            .write(answers)
            .specialize(kTraceFiltered, level.scene.rays.filtered)
            .specialize(kTraceTinted, level.scene.rays.tinted)
            .dispatch(uvec2(uint(count), 1));
        graph.output(answers);
        const double ms = executor.run(graph, level.set).milliseconds;
        const std::vector<std::uint8_t> bytes = executor.download(answers);
        hits.resize(count);
        std::memcpy(hits.data(), bytes.data(), bytes.size());
        return ms;
    };
    std::size_t count = kFewest;
    trace(count); // compiles
    while (std::min(trace(count), trace(count)) < kLongEnough && count < kRays) count *= 4;
    Timing timing{double(crowd.world.triangles().size()), {}, {}};
    for (int i = 0; i < kTurns; ++i) timing.ms.push_back(trace(count));
    timing.ms = ofAMillion(timing.ms, count);
    std::vector<float> distances;
    for (const Hit& hit : hits) distances.push_back(hit.distance);
    timing.otherwise = otherwise(crowd, distances);
    return timing;
}

Timing withoutTree(Gpu*, double triangles)
{
    const Crowd crowd(triangles);
    EveryTriangle all(crowd.world);
    return {double(crowd.world.triangles().size()), ofAMillion(cpuTimes([&] { all.ask(crowd.rays); }), kAsked), 0.0};
}

// The frame's G-buffer, and nothing after it.
Timing rasterised(Gpu* gpu, double triangles)
{
    const Scene scene = clutter(std::size_t(triangles));
    Setup setup;
    setup.settings.size = kPicture;
    setup.settings.effects.base = Overrides::Base::none;
    setup.truth.camera = scene.cameras.front();
    Stage stage = makeStage(*gpu, scene, nullptr, setup.settings);
    Executor executor(*gpu);
    const Sweep sweep{.subject = "geometry", .held = Held::picture};
    return {double(scene.indices.size() / 3), draw(executor, stage, setup, sweep, kTurns).ms, {}};
}
}
