// Milliseconds of a frame, pass by pass, after the frames that compile and warm up.
#include "engine/frame/frame.hpp"
#include "bench/bench.hpp"
#include "bench/child.hpp"
#include <chrono>
#include <ctime>
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

struct TimedFrame {
    FrameStats stats;
    double wall, cpu; // ms
};

static TimedFrame drawOnce(Executor& executor, Stage& stage, const Camera& camera, const Settings& settings)
{
    const std::clock_t cpu = std::clock();
    const auto began = std::chrono::steady_clock::now();
    Graph graph;
    graph.output(drawFrame(graph, stage, nextView(stage, camera, settings), settings).displayed);
    TimedFrame frame;
    frame.stats = executor.run(graph, stage.level->set);
    frame.wall = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - began).count();
    frame.cpu = 1e3 * double(std::clock() - cpu) / CLOCKS_PER_SEC;
    return frame;
}

static json measure(const BenchOptions& options, const std::filesystem::path& baked)
{
    const int warm = 3, wanted = options.quick ? 9 : 31;
    const double longest = options.quick ? 20.0 : 60.0; // s; on a slow device fewer frames must do

    const Baked level = readBaked(baked);
    const Settings settings = adoptLevel({}, level.scene);
    Gpu gpu(deviceOptions(options.device));
    Stage stage = makeStage(gpu, level.scene, &level, settings);
    Executor executor(gpu);
    const Camera camera = findCamera(level.scene, "");
    for (int i = 0; i < warm; ++i) drawOnce(executor, stage, camera, settings);
    std::vector<TimedFrame> frames;
    double spent = 0.0;
    while (int(frames.size()) < wanted && (spent < longest || frames.size() < 3)) {
        frames.push_back(drawOnce(executor, stage, camera, settings));
        spent += 1e-3 * frames.back().wall;
    }

    const auto medianOf = [&](auto value) {
        std::vector<double> values;
        for (const TimedFrame& frame : frames) values.push_back(value(frame));
        return median(values);
    };
    json passes = json::array();
    const FrameStats& last = frames.back().stats;
    for (std::size_t p = 0; p < last.passes.size(); ++p)
        passes.push_back({{"name", last.passes[p].name}, {"ms", medianOf([&](const TimedFrame& frame) {
                                                              return p < frame.stats.passes.size() ? frame.stats.passes[p].milliseconds
                                                                                                   : 0.0;
                                                          })}});
    return {{"device", gpu.device.deviceName},
            {"size", {settings.size.x, settings.size.y}},
            {"frames", frames.size()},
            {"frame_ms", medianOf([](const TimedFrame& frame) { return frame.stats.milliseconds; })},
            {"wall_ms", medianOf([](const TimedFrame& frame) { return frame.wall; })},
            {"cpu_ms", medianOf([](const TimedFrame& frame) { return frame.cpu; })},
            {"gpu_bytes", last.gpuBytes},
            {"draws", last.draws},
            {"triangles", last.triangles},
            {"passes", passes}};
}

json benchFrame(const BenchOptions& options, const std::filesystem::path& baked)
{
    return inChild([&] { return measure(options, baked); });
}
}
