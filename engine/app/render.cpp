// `afterglow render`: a level or its bake to a picture, and what the picture cost.
#include "engine/app/budget/budget.hpp"
#include "engine/app/level.hpp"
#include "engine/app/render_layers.hpp"
#include "engine/app/runtime_verbs.hpp"
#include "engine/app/study/law.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include "engine/core/interrupt.hpp"
#include "engine/core/log.hpp"
#include "engine/frame/frame.hpp"
#include "engine/gpu/readback.hpp"
#include <algorithm>
#include <nlohmann/json.hpp>

namespace afterglow
{
namespace
{
using nlohmann::json;

// The median frame after warm-up, pass by pass; passes that only the first frame runs are reported from it, apart from the frame's time.
json statistics(const Gpu& gpu, const RenderCommand& command, const Plan& plan, const std::optional<Fitted>& fitted,
                const std::vector<FrameStats>& frames)
{
    const std::size_t warm = frames.size() > 1 ? 1 : 0;
    const auto medianOf = [&](auto value) {
        std::vector<double> values;
        for (std::size_t i = warm; i < frames.size(); ++i) values.push_back(value(frames[i]));
        return quartiles(values).median;
    };
    const FrameStats& last = frames.back();
    json passes = json::array(), once = json::array(), effects = json::array();
    for (const PassStats& pass : last.passes)
        passes.push_back({{"name", pass.name},
                          {"ms", medianOf([&](const FrameStats& frame) {
                               for (const PassStats& same : frame.passes)
                                   if (same.name == pass.name) return same.milliseconds;
                               return 0.0;
                           })},
                          {"reads", pass.reads},
                          {"writes", pass.writes}});
    for (const PassStats& pass : frames.front().passes)
        if (std::none_of(last.passes.begin(), last.passes.end(), [&](const PassStats& p) { return p.name == pass.name; }))
            once.push_back({{"name", pass.name}, {"ms", pass.milliseconds}, {"reads", pass.reads}, {"writes", pass.writes}});
    for (const PlannedEffect& effect : plan.effects)
        effects.push_back({{"effect", effect.effect}, {"on", effect.on}, {"reason", effect.reason}});
    json all = {{"device", gpu.device.deviceName},
                {"size", {command.settings.size.x, command.settings.size.y}},
                {"frame_ms", medianOf([](const FrameStats& frame) { return frame.milliseconds; })},
                {"frames", frames.size() - warm},
                {"passes", passes},
                {"first_frame_passes", once},
                {"pipelines", last.pipelines},
                {"gpu_bytes", last.gpuBytes},
                {"draws", last.draws},
                {"triangles", last.triangles},
                {"plan", effects}};
    if (fitted) all["budget"] = jsonOf(*fitted);
    return all;
}

// Three channels of what was drawn, finite whatever a driver did.
Image threeChannels(const Image& drawn, float most)
{
    Image picture(drawn.width, drawn.height, 3);
    for (std::size_t i = 0; i < std::size_t(drawn.width) * drawn.height; ++i)
        for (int c = 0; c < 3; ++c) {
            const float value = drawn.pixels[i * drawn.channels + c];
            picture.pixels[i * 3 + c] = value > 0.0f ? std::min(value, most) : 0.0f;
        }
    return picture;
}
}

void renderVerb(const RenderCommand& command)
{
    requireEnding(command.output, {".png", ".exr"});
    if (!command.layers.empty()) requireEnding(command.layers, {".exr"});
    const bool traced = command.settings.mode == Mode::truth;
    const bool asDisplayed = suffix(command.output) == ".png";
    requireApart({{"-o", command.output}, {"--layers", command.layers}, {"--stats", command.stats}}, {{"LEVEL|DIR", command.target}});
    requireWritable(command.output);
    for (const std::filesystem::path& beside : {command.layers, command.stats})
        if (!beside.empty()) requireWritable(beside);
    const Target target = loadTarget(command.target);
    Settings settings = adoptLevel(command.settings, target.scene());
    settings.layers = !command.layers.empty();
    const Camera camera = findCamera(target.scene(), command.camera);

    Gpu gpu(deviceOptions(command.device));
    Executor executor(gpu);
    std::optional<Fitted> fitted;
    if (command.budgetMs) {
        fitted = fitBudget({target, command.target, settings, camera, executor}, *command.budgetMs, command.progress);
        for (const std::string& line : spoken(*fitted)) note(line);
        if (settings.layers) note("--layers are drawn beside the frame: the budget is without them");
        settings = fitted->settings;
    }
    Stage stage = makeStage(gpu, target.scene(), target.bake(), settings);
    if (fitted) tellGivenUp(stage.plan, command.settings, *fitted);
    for (const std::string& line : stage.notes) note(line);
    if (settings.layers && stage.plan.on("upscale") && !stage.plan.on("antialias"))
        throw Error("--layers of a picture drawn smaller are gathered by antialias: let it on, or leave --render-scale out", Exit::usage);
    std::vector<FrameStats> frames;
    Pictures pictures;
    Texture wanted;
    const int wantedFrames = command.frames > 0 ? command.frames : framesOf(stage.plan, settings);
    Progress progress(traced ? command.progress : ProgressStyle::none);
    progress.begin("truth", std::uint64_t(wantedFrames), "samples");
    for (int i = command.stats.empty() ? 0 : -1; i < wantedFrames; ++i) { // that before the first compiles, and is not timed
        if (i == 0) forget(stage);
        stopIfInterrupted();
        Graph graph;
        pictures =
            traced ? drawTruth(graph, stage, camera, settings) : drawFrame(graph, stage, nextView(stage, camera, settings), settings);
        wanted = asDisplayed ? pictures.displayed : pictures.radiance;
        graph.output(wanted);
        if (settings.layers) outputLayers(graph, pictures);
        frames.push_back(executor.run(graph, stage.level->set));
        if (i >= 0) progress.advance(1);
    }
    progress.end();
    if (asDisplayed)
        writePng(command.output, readback8(gpu.memory, executor.image(wanted)));
    else
        writeExr(command.output, threeChannels(executor.download(wanted), traced ? kFloatMax : kHalfMax));
    if (settings.layers) writeLayers(command.layers, downloadLayers(executor, pictures));
    if (!command.stats.empty()) writeText(command.stats, statistics(gpu, command, stage.plan, fitted, frames).dump(2) + "\n");
    for (const std::string& message : gpu.device.messages) warning(message);
}
}
