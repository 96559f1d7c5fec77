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

// The frames of one stage of a level, which takes turns with another; after those that compile and warm up.
struct Turns {
    Gpu gpu;
    Executor executor{gpu};
    Stage stage;
    std::vector<TimedFrame> frames;

    Turns(const BenchOptions& options, const Baked& level, const Settings& settings);
};

Turns::Turns(const BenchOptions& options, const Baked& level, const Settings& settings)
    : gpu(deviceOptions(options.device)), stage(makeStage(gpu, level.scene, &level, settings))
{
    const Camera camera = findCamera(level.scene, "");
    for (int warm = 0; warm < 3; ++warm) drawOnce(executor, stage, camera, settings);
}

template <typename Value>
static double medianOf(const Turns& turns, Value value)
{
    std::vector<double> values;
    for (const TimedFrame& frame : turns.frames) values.push_back(value(frame));
    return median(values);
}

static double passMs(const TimedFrame& frame, const std::string& name)
{
    for (const PassStats& pass : frame.stats.passes)
        if (pass.name == name) return pass.milliseconds;
    return 0.0;
}

static json measure(const BenchOptions& options, const std::filesystem::path& baked)
{
    const int wanted = options.quick ? 9 : 31;
    const double longest = options.quick ? 20.0 : 60.0; // s; on a slow device fewer frames must do

    const Baked level = readBaked(baked);
    const Settings settings = adoptLevel({}, level.scene);
    Settings unprobed = settings;
    unprobed.effects.forced["probes"] = false;
    const Camera camera = findCamera(level.scene, "");
    Turns whole(options, level, settings), without(options, level, unprobed);
    double spent = 0.0;
    while (int(whole.frames.size()) < wanted && (spent < longest || whole.frames.size() < 3)) {
        whole.frames.push_back(drawOnce(whole.executor, whole.stage, camera, settings));
        without.frames.push_back(drawOnce(without.executor, without.stage, camera, unprobed)); // by turns: both meet the same machine
        spent += 1e-3 * (whole.frames.back().wall + without.frames.back().wall);
    }

    const auto ms = [](const Turns& turns, const std::string& pass) {
        return medianOf(turns, [&](const TimedFrame& frame) { return passMs(frame, pass); });
    };
    json passes = json::array();
    const FrameStats& last = whole.frames.back().stats;
    for (const PassStats& pass : last.passes) passes.push_back({{"name", pass.name}, {"ms", ms(whole, pass.name)}});
    return {{"device", whole.gpu.device.deviceName},
            {"size", {settings.size.x, settings.size.y}},
            {"frames", whole.frames.size()},
            {"frame_ms", medianOf(whole, [](const TimedFrame& frame) { return frame.stats.milliseconds; })},
            {"wall_ms", medianOf(whole, [](const TimedFrame& frame) { return frame.wall; })},
            {"cpu_ms", medianOf(whole, [](const TimedFrame& frame) { return frame.cpu; })},
            {"gpu_bytes", last.gpuBytes},
            {"draws", last.draws},
            {"triangles", last.triangles},
            {"probe_lookups_of_lighting", 1.0 - ms(without, "lighting") / ms(whole, "lighting")},
            {"passes", passes}};
}

json benchFrame(const BenchOptions& options, const std::filesystem::path& baked)
{
    return inChild([&] { return measure(options, baked); });
}
}
