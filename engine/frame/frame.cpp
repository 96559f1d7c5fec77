#include "engine/frame/frame.hpp"
#include "engine/effects/fog/fog.hpp"
#include "engine/effects/geometry/geometry.hpp"
#include "engine/effects/planar/planar.hpp"
#include "engine/effects/portal/portal.hpp"
#include "engine/frame/windows.hpp"

namespace afterglow
{
Pictures drawFrame(Graph& graph, Stage& stage, const View& eye, const Settings& settings)
{
    const Plan& plan = stage.plan;
    const GpuLevel& level = *stage.level;
    const Windows windows = windowsOf(stage, eye, settings);
    const View view = marked(eye, level.scene, windows.mirrors);
    const GBuffer surfaces =
        geometry(graph, view, level.scene, {.masked = plan.on("masked"), .emission = stage.emission, .objects = settings.layers});
    const Shadows shadows = plan.on("shadow") ? shadow(graph, stage.shadows, level.scene, view) : Shadows{};
    Layers layers;
    Texture image =
        lighting(graph, view, surfaces, shadows, level, stage.surroundings, lightingParts(plan), settings.layers ? &layers : nullptr);
    const auto seenIn = [&](const std::vector<VirtualView>& views) { return lookThrough(graph, stage, views, shadows, settings); };
    if (plan.on("planar")) planar(graph, view, surfaces, level.scene, seenIn(windows.mirrors), image, layers);
    if (plan.on("portal")) portal(graph, view, surfaces, level.scene, seenIn(windows.portals), image, layers);
    if (plan.on("fog")) image = fog(graph, view, surfaces, shadows, level, stage.surroundings.ambient, image, settings.fog);
    if (settings.layers) surfaceLayers(graph, view, surfaces, layers);
    return {image, display(graph, image, settings.display), layers};
}
}
