// Rays per second of the tree alone: Embree behind World, nothing shaded. What the bake reaches beside it is the bake's own overhead.
#include "baker/ray_kinds.hpp"
#include "bench/bench.hpp"
#include "bench/child.hpp"
#include "engine/core/jobs.hpp"
#include <chrono>
#include <ctime>
#include <map>
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

constexpr std::size_t kChunk = 16384; // rays of one unit of work

// Traces rays[first, last) and counts those that met something.
using Trace = std::uint64_t (*)(const World& world, const Ray* first, const Ray* last);

static std::uint64_t traceSingly(const World& world, const Ray* first, const Ray* last)
{
    std::uint64_t met = 0;
    for (; first != last; ++first) met += world.closestHit(*first).distance < kRayFar ? 1u : 0u;
    return met;
}

static std::uint64_t tracePackets(const World& world, const Ray* first, const Ray* last)
{
    std::uint64_t met = 0;
    Hit hits[kPacket];
    for (; first != last; first += kPacket) {
        world.closestHits(first, hits, kPacket, /* coherent= */ false);
        for (const Hit& hit : hits) met += hit.distance < kRayFar ? 1u : 0u;
    }
    return met;
}

static std::uint64_t traceShadows(const World& world, const Ray* first, const Ray* last)
{
    std::uint64_t met = 0;
    for (; first != last; ++first) met += world.transmittance(*first) == vec3(0.0f) ? 1u : 0u;
    return met;
}

static std::uint64_t traceShadowPackets(const World& world, const Ray* first, const Ray* last)
{
    std::uint64_t met = 0;
    RayLanes rays;
    for (; first != last; first += kPacket) {
        for (int i = 0; i < kPacket; i++) {
            rays.origin.set(i, first[i].origin), rays.direction.set(i, first[i].direction);
            rays.far[i] = first[i].far, rays.asked[i] = -1;
        }
        world.unoccluded(rays);
        for (const int free : rays.asked) met += free ? 0u : 1u;
    }
    return met;
}

struct Kind {
    const char* name; // as bake.json has it
    Trace trace;
    std::vector<Ray> rays;
    std::vector<double> seconds, cpuSeconds; // of each repetition
    std::uint64_t met = 0;
};

static void timeOnce(const World& world, Kind& kind, int threads)
{
    std::vector<std::uint64_t> met((kind.rays.size() + kChunk - 1) / kChunk);
    const std::clock_t cpu = std::clock(); // of all threads
    const auto began = std::chrono::steady_clock::now();
    parallelFor(met.size(), threads, [&](std::size_t i) {
        const Ray* rays = kind.rays.data();
        met[i] = kind.trace(world, rays + i * kChunk, rays + std::min((i + 1) * kChunk, kind.rays.size()));
    });
    kind.seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
    kind.cpuSeconds.push_back(double(std::clock() - cpu) / CLOCKS_PER_SEC);
    kind.met = 0;
    for (std::uint64_t count : met) kind.met += count;
}

static json measure(const BenchOptions& options, const json& bake)
{
    const std::size_t count = (options.quick ? 16 : 64) * kChunk;
    const int repetitions = options.quick ? 5 : 9;
    const Scene scene = loadLevel(options.level);
    const World world(scene, Content::staticOnly);
    const LightTransport transport(world, scene.lights);
    const RayKinds draw(transport);
    Kind kinds[] = {{"closest_packed", tracePackets, draw.packets(count)},
                    {"closest", traceSingly, draw.incoherent(count)},
                    {"shadow", traceShadows, draw.shadow(count)},
                    {"shadow_packed", traceShadowPackets, draw.shadowPackets(count)}};

    // The kinds in turns, so that a neighbour's load is not one kind's alone; the first round warms the caches and is not counted.
    for (Kind& kind : kinds) timeOnce(world, kind, options.threads), kind.seconds.clear(), kind.cpuSeconds.clear();
    for (int i = 0; i < repetitions; ++i)
        for (Kind& kind : kinds) timeOnce(world, kind, options.threads);

    json result = {{"threads", threadCount(options.threads)}, {"repetitions", repetitions}, {"triangles", world.triangles().size()}};
    std::map<std::string, dvec2> costs; // s and CPU s of a ray
    for (const Kind& kind : kinds) {
        const double rays = double(kind.rays.size()), seconds = median(kind.seconds), cpu = median(kind.cpuSeconds);
        result[kind.name] = {{"rays", kind.rays.size()},
                             {"rays_per_second", rays / seconds},
                             {"rays_per_cpu_second", rays / cpu},
                             {"met", double(kind.met) / rays}};
        costs[kind.name] = dvec2(seconds, cpu) / rays;
    }
    // What Embree alone takes for as many rays of each kind as a product had
    for (const auto& [name, product] : bake["products"].items()) {
        dvec2 spent(0.0);
        for (const auto& [kind, cost] : costs) spent += cost * product.value("ray_kinds", json::object()).value(kind, 0.0);
        const double rays = product.value("rays", 0.0);
        if (rays > 0.0) result["mix"][name] = {{"rays_per_second", rays / spent.x}, {"rays_per_cpu_second", rays / spent.y}};
    }
    return result;
}

json benchRays(const BenchOptions& options, const json& bake)
{
    return inChild([&] { return measure(options, bake); });
}
}
