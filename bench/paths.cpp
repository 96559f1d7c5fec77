// Path tracing on the GPU, one organisation beside the other: what compiling costs at first, and a sample of every pixel from then on.
#include "bench/bench.hpp"
#include "bench/child.hpp"
#include "engine/frame/frame.hpp"
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

struct Way {
    std::string name;
    Stage stage;
    double compileWall = 0, compileCpu = 0; // s
    std::vector<double> wall, cpu;          // ms of a sample
};

static std::vector<Way> waysOf(Gpu& gpu, const Scene& scene, Settings settings)
{
    std::vector<Way> ways;
    for (const auto& [word, tracing] : tracingWords()) {
        if (tracing == Tracing::automatic || !canTrace(gpu.device, tracing)) continue;
        settings.tracing = tracing;
        ways.push_back({word, makeStage(gpu, scene, nullptr, settings), 0, 0, {}, {}});
    }
    return ways;
}

static void sampleOnce(Executor& executor, Way& one, const Camera& camera, const Settings& settings)
{
    const std::clock_t cpu = std::clock(); // of all threads: on a CPU driver they are the device
    const auto began = std::chrono::steady_clock::now();
    Graph graph;
    graph.output(drawTruth(graph, one.stage, camera, settings).radiance);
    executor.run(graph, one.stage.level->set);
    one.wall.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - began).count());
    one.cpu.push_back(1e3 * double(std::clock() - cpu) / CLOCKS_PER_SEC);
}

static json measure(const BenchOptions& options)
{
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1); // the first run, every time
    const int samples = options.quick ? 9 : 31;
    const Scene scene = loadLevel(options.level);
    Settings settings = adoptLevel({}, scene);
    settings.mode = Mode::truth;
    settings.size = uvec2(128);
    settings.truth.samples = kMostTruthSamples;
    const Camera camera = findCamera(scene, "");
    Gpu gpu(deviceOptions(options.device));
    tracingOn(gpu.device, Tracing::automatic); // or it cannot, and says so
    Executor executor(gpu);
    std::vector<Way> ways = waysOf(gpu, scene, settings);
    for (Way& one : ways) {
        sampleOnce(executor, one, camera, settings);
        one.compileWall = 1e-3 * one.wall.back(), one.compileCpu = 1e-3 * one.cpu.back();
        one.wall.clear(), one.cpu.clear();
    }
    // In turns, so that a neighbour's load is not one way's alone
    for (int i = 0; i < samples; ++i)
        for (Way& one : ways) sampleOnce(executor, one, camera, settings);

    json rows = json::array();
    for (const Way& one : ways)
        rows.push_back({{"tracing", one.name},
                        {"first_s", one.compileWall},
                        {"first_cpu_s", one.compileCpu},
                        {"sample_ms", median(one.wall)},
                        {"sample_cpu_ms", median(one.cpu)}});
    return {{"device", gpu.device.deviceName}, {"size", {settings.size.x, settings.size.y}}, {"samples", samples}, {"rows", rows}};
}

json benchPaths(const BenchOptions& options)
{
    return inChild([&] { return measure(options); });
}
}
