#include "engine/frame/frame.hpp"
#include "engine/effects/fog/fog.hpp"
#include "engine/effects/geometry/geometry.hpp"
#include "engine/effects/reflection/reflection.hpp"

namespace afterglow
{
Pictures drawFrame(Graph& graph, Stage& stage, const View& view, const Settings& settings)
{
    const Plan& plan = stage.plan;
    const GpuLevel& level = *stage.level;
    const GBuffer surfaces =
        geometry(graph, view, level.scene, {.masked = plan.on("masked"), .emission = stage.emission, .objects = settings.layers});
    const Shadows shadows = plan.on("shadow") ? shadow(graph, stage.shadows, level.scene, view) : Shadows{};
    const LightingParts parts{.lightmaps = plan.on("lightmaps"),
                              .probes = plan.on("probes"),
                              .reflections = plan.on("reflections"),
                              .fog = plan.on("fog"),
                              .mirrored = plan.on("reflection")};
    Layers made;
    Layers* layers = settings.layers ? &made : nullptr;
    Lit lit = lighting(graph, view, surfaces, shadows, level, stage.surroundings, parts, layers);
    if (plan.on("reflection")) lit = reflection(graph, view, surfaces, lit, parts.reflections, settings.reflection, layers);
    if (plan.on("clear")) clearSurfaces(graph, view, surfaces, shadows, level, lit, parts, layers);
    Texture image = lit.radiance;
    if (plan.on("fog")) image = fog(graph, view, surfaces, shadows, level, stage.surroundings.ambient, image, settings.fog);
    if (layers) surfaceLayers(graph, view, surfaces, *layers);
    return {image, display(graph, image, settings.display), made};
}
}
