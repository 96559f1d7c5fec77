// `afterglow view`: a level or its bake in a window. Shaders are reloaded as they are edited; a frame that fails leaves the last picture.
#include "engine/app/fly.hpp"
#include "engine/app/viewer.hpp"
#include "engine/core/error.hpp"
#include "engine/core/interrupt.hpp"
#include "engine/core/log.hpp"
#include "engine/gpu/readback.hpp"
#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

namespace afterglow
{
namespace
{
constexpr double kLookEvery = 0.5;  // s between two looks at the shaders' files
constexpr double kAdaptation = 0.4; // s until 63 % of a change of exposure has happened: an eye needs about that for brighter light

// An effect is free when asking for the opposite of what is called for gives the opposite.
std::vector<OfferedEffect> offeredEffects(const Target& target, const Settings& settings)
{
    const std::vector<Need> called = needs(target.scene(), target.bake() && target.bake()->directAll);
    const Evidence evidence = evidenceOf(target.scene(), target.bake(), settings);
    const Plan planned = plan(called, evidence, {});
    Overrides opposite;
    for (const PlannedEffect& effect : planned.effects) opposite.forced[effect.effect] = !effect.on;
    const Plan overruled = plan(called, evidence, opposite);
    std::vector<OfferedEffect> offered;
    for (const PlannedEffect& effect : planned.effects) offered.push_back({effect, overruled.on(effect.effect) != effect.on});
    return offered;
}

GpuImage pictureFor(Gpu& gpu, uvec2 size) { return gpu.memory.image("window", {VK_FORMAT_R8G8B8A8_UNORM, {size, 1}}); }

void obey(Viewer& viewer, const Controls& controls)
{
    for (const char key : controls.pressed) {
        viewer.reload |= key == 'R';
        viewer.save |= key == 'P';
        if (key == 'H') viewer.panel = !viewer.panel;
        if (key == 'T') viewer.look = viewer.look == ViewMode::truth ? ViewMode::raster : ViewMode::truth;
        if (key == 'V') viewer.look = viewer.look == ViewMode::wipe ? ViewMode::raster : ViewMode::wipe;
        if (key == 'F') viewer.look = viewer.look == ViewMode::difference ? ViewMode::raster : ViewMode::difference;
        if (key >= '1' && key < '1' + int(std::min<std::size_t>(viewer.cameras.size(), 9))) chooseCamera(viewer, key - '1');
    }
    viewer.time += controls.seconds;
    viewer.settings.display.adapt = float(-std::expm1(-controls.seconds / kAdaptation));
    viewer.speed = std::clamp(viewer.speed * std::exp2(0.25f * controls.scroll), 1e-3f, 1e3f);
    viewer.eye = flown(viewer.eye, controls, viewer.speed);
}

void reloadShaders(Viewer& viewer)
{
    const std::vector<std::string> lines = viewer.gpu.pipelines.reload();
    viewer.looked = viewer.time;
    if (!lines.empty() || viewer.reload) viewer.messages = lines.empty() ? std::vector<std::string>{"no shader was edited"} : lines;
    if (!lines.empty()) { // what is kept over frames was drawn by the old shaders
        viewer.stage.shadows.drawn = false;
        forget(viewer.stage);
    }
    viewer.reload = false;
}

// Where the new stage cannot be had, the old one goes on, and the look that it can draw.
void restage(Viewer& viewer)
{
    if (viewer.look == ViewMode::raster) viewer.settings.mode = Mode::raster; // nobody looks at paths: their tables are let go
    try {
        viewer.stage = makeStage(viewer.gpu, viewer.target.scene(), viewer.target.bake(), viewer.settings);
    } catch (const Error& error) {
        viewer.messages = {error.what()};
        viewer.settings.mode = viewer.stage.memory ? Mode::both : Mode::raster;
        viewer.settings.show = kShowNothing; // of which every stage has enough
        if (!viewer.stage.memory) viewer.look = ViewMode::raster;
    }
}

void drawPicture(Viewer& viewer, uvec2 size)
{
    readyPaths(viewer);
    if (std::exchange(viewer.restage, false)) restage(viewer);
    viewer.settings.size = size;
    GpuImage resized;
    const bool fits = viewer.picture.shape.size == uvec3(size, 1);
    if (!fits) resized = pictureFor(viewer.gpu, size);

    Graph graph;
    const ShownPictures drawn = drawShown(graph, viewer);
    const bool compares = viewer.look == ViewMode::difference;
    if (!compares || !fits) viewer.differs = {};
    if (compares) {
        graph.output(drawn.raster);
        graph.output(drawn.truth);
    } else {
        const Texture kept = graph.import(fits ? viewer.picture : resized);
        graph.copy("window", drawn.displayed, kept);
        graph.output(kept);
    }
    viewer.stats = viewer.executor.run(graph, viewer.stage.level->set);
    if (!fits) viewer.picture = std::move(resized);
    if (compares) showDifference(viewer, drawn);
    for (const PassStats& pass : viewer.stats.passes) {
        double& smooth = viewer.milliseconds.try_emplace(pass.name, pass.milliseconds).first->second;
        smooth += 0.1 * (pass.milliseconds - smooth);
    }
}

void savePicture(Viewer& viewer)
{
    viewer.save = false;
    const std::filesystem::path path = std::filesystem::absolute("view.png");
    try {
        writePng(path, readback8(viewer.gpu.memory, viewer.picture));
        viewer.messages = {"wrote " + path.string()};
    } catch (const Error& error) {
        viewer.messages = {error.what()};
    }
}
}

void chooseCamera(Viewer& viewer, int index)
{
    viewer.camera = index;
    viewer.eye = viewer.cameras[std::size_t(index)];
}

Viewer::Viewer(const ViewCommand& command)
    : target(loadTarget(command.target)), settings(adoptLevel(command.settings, target.scene())), effects(offeredEffects(target, settings)),
      cameras(target.scene().cameras), eye(findCamera(target.scene(), command.camera)), speed(flyingSpeed(target.scene())),
      window(command.target.filename().string() + " - Afterglow", settings.size), gpu(window.deviceOptions(command.device)), executor(gpu),
      stage(makeStage(gpu, target.scene(), target.bake(), settings)), screen(window, gpu), picture(pictureFor(gpu, settings.size))
{
    if (cameras.empty()) cameras.push_back(eye);
    int asked = 0;
    for (int i = int(cameras.size()) - 1; i >= 0; --i)
        if (cameras[std::size_t(i)].name == eye.name && cameras[std::size_t(i)].toWorld == eye.toWorld) asked = i;
    chooseCamera(*this, asked);
}

void step(Viewer& viewer, const Controls& controls)
{
    obey(viewer, controls);
    if (viewer.reload || viewer.time > viewer.looked + kLookEvery) reloadShaders(viewer);
    const uvec2 size = viewer.window.size();
    if (!size.x || !size.y) { // minimized
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        return;
    }
    try {
        drawPicture(viewer, size);
        viewer.failure.clear();
    } catch (const Error& error) {
        viewer.failure = error.what();
        viewer.stage.shadows.drawn = false; // declared as drawn, but the frame did not run
        forget(viewer.stage);
    }
    if (viewer.save) savePicture(viewer);
    viewer.screen.show(viewer.picture, [&](Panel& panel) {
        if (viewer.panel) drawPanel(panel, viewer);
    });
}

void viewVerb(const ViewCommand& command)
{
    tellWatching();
    Viewer viewer(command);
    for (const std::string& line : viewer.stage.notes) note(line);
    Controls controls;
    for (int frame = 0; (command.frames == 0 || frame < command.frames) && viewer.window.poll(controls); ++frame) step(viewer, controls);
    for (const std::string& message : viewer.gpu.device.messages) warning(message);
}
}
