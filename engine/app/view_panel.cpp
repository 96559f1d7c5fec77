// The panel of the viewer. What it changes shows in the next frame.
#include "engine/app/viewer.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace afterglow
{
namespace
{
std::string lightOf(const Target& target)
{
    if (!target.baked) return "not baked: direct light and a constant ambient only; `afterglow bake` adds what bounces";
    const Baked& baked = *target.baked;
    return fmt::format("baked: lightmaps {}, probes {}, reflections {}", baked.lightmaps.size(), baked.probes.probes.size(),
                       baked.reflections.size());
}

void drawCamera(Panel& panel, Viewer& viewer)
{
    std::vector<std::string> names;
    for (const Camera& camera : viewer.cameras) names.push_back(fmt::format("{} {}", names.size() + 1, camera.name));
    int chosen = viewer.camera;
    if (panel.choice("camera", chosen, names)) chooseCamera(viewer, chosen);
    panel.slider("m/s", viewer.speed, 0.0f, 20.0f);
}

void drawChoice(Panel& panel, Viewer& viewer)
{
    int look = int(viewer.look);
    if (panel.choice("picture", look, {"raster", "path traced (T)", "one beside the other (V)", "their difference (F)"}))
        viewer.look = ViewMode(look);
    if (viewer.look == ViewMode::wipe) panel.slider("raster up to", viewer.wipe, 0.0f, 1.0f);
    if (viewer.look != ViewMode::raster) panel.text(fmt::format("{} paths a pixel", viewer.stage.traced.count));
    if (viewer.look == ViewMode::difference && viewer.differs)
        panel.text(fmt::format("FLIP {:.4f} on average; from black to pale yellow", *viewer.differs));
}

// Off, the probes of the level may be off too: what is chosen brings back those that it shows.
void drawShown(Panel& panel, Viewer& viewer)
{
    if (!viewer.target.baked) return;
    int shown = int(viewer.settings.show);
    if (!panel.choice("show", shown, {"the picture", "probes", "how far they were moved", "cells", "largest weight", "reflection probes"}))
        return;
    const bool held = uint(shown) == kShowInfluence ? !viewer.target.baked->reflections.empty() : !viewer.target.baked->probes.empty();
    if (uint(shown) != kShowNothing && !held) return;
    viewer.settings.show = uint(shown);
    if (uint(shown) != kShowNothing) viewer.settings.effects.forced[uint(shown) == kShowInfluence ? "reflections" : "probes"] = true;
    viewer.restage = true;
}

void drawDisplay(Panel& panel, DisplayParameters& display)
{
    bool automatic = !display.exposureEv;
    if (panel.toggle("exposure from the picture", automatic)) display.exposureEv = automatic ? std::nullopt : std::optional(0.0f);
    if (display.exposureEv) panel.slider("EV", *display.exposureEv, -16.0f, 16.0f);
    int curve = int(display.curve);
    if (panel.choice("tone curve", curve, {"none", "reinhard", "aces", "hable"})) display.curve = ToneCurve(curve);
}

// Each with what the level calls for, and why.
void drawEffects(Panel& panel, Viewer& viewer)
{
    for (const OfferedEffect& offered : viewer.effects) {
        const PlannedEffect& called = offered.called;
        const std::string line = fmt::format("{}: {}, {}", called.effect, called.on ? "on" : "off", called.reason);
        bool on = viewer.stage.plan.on(called.effect);
        if (!offered.free)
            panel.text(line);
        else if (panel.toggle(line, on)) {
            viewer.settings.effects.forced[called.effect] = on;
            viewer.restage = true;
        }
    }
    if (panel.button("as the level calls for")) {
        viewer.settings.effects = {};
        viewer.restage = true;
    }
}

void drawPasses(Panel& panel, const Viewer& viewer)
{
    double most = 0.0;
    for (const PassStats& pass : viewer.stats.passes) most = std::max(most, viewer.milliseconds.at(pass.name));
    for (const PassStats& pass : viewer.stats.passes) {
        const double milliseconds = viewer.milliseconds.at(pass.name);
        panel.bar(fmt::format("{} {:.2f} ms", pass.name, milliseconds), float(milliseconds), float(most));
    }
}
}

void drawPanel(Panel& panel, Viewer& viewer)
{
    panel.begin(viewer.target.scene().path.filename().string());
    panel.text("fly: W A S D, Q down, E up, shift faster, scroll for speed; look: drag; 1-9 cameras; T path traced, V beside the "
               "raster frame, F where they differ; R reload shaders; P view.png; H hide this; Esc leave");
    panel.text(viewer.gpu.device.deviceName);
    panel.text(lightOf(viewer.target));
    panel.text(fmt::format("{:.2f} ms on the GPU, {}x{}, {} draws, {} triangles, {:.0f} MiB", viewer.stats.milliseconds,
                           viewer.settings.size.x, viewer.settings.size.y, viewer.stats.draws, viewer.stats.triangles,
                           double(viewer.stats.gpuBytes) / (1 << 20)));
    if (!viewer.failure.empty()) panel.text("this is the last whole picture: " + viewer.failure);
    for (const std::string& line : viewer.messages) panel.text(line);
    drawCamera(panel, viewer);
    drawChoice(panel, viewer);
    drawShown(panel, viewer);
    drawDisplay(panel, viewer.settings.display);
    if (panel.section("passes")) drawPasses(panel, viewer);
    if (panel.section("effects")) drawEffects(panel, viewer);
    panel.end();
}
}
