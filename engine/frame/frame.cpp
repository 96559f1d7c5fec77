#include "engine/frame/frame.hpp"
#include "engine/effects/bloom/bloom.hpp"
#include "engine/effects/fog/fog.hpp"
#include "engine/effects/geometry/geometry.hpp"
#include "engine/effects/upscale/upscale.hpp"

namespace afterglow
{
Pictures drawFrame(Graph& graph, Stage& stage, const View& view, const Settings& settings)
{
    const Plan& plan = stage.plan;
    const GpuLevel& level = *stage.level;
    const GBuffer surfaces =
        geometry(graph, view, level.scene, {.masked = plan.on("masked"), .emission = stage.emission, .objects = settings.layers});
    const Shadows shadows = plan.on("shadow") ? shadow(graph, stage.shadows, level.scene, view) : Shadows{};
    Layers layers;
    Texture image = lighting(graph, view, surfaces, shadows, level, stage.surroundings,
                             {.lightmaps = plan.on("lightmaps"),
                              .probes = plan.on("probes"),
                              .reflections = plan.on("reflections"),
                              .clear = plan.on("clear"),
                              .fog = plan.on("fog")},
                             settings.layers ? &layers : nullptr);
    if (plan.on("fog")) image = fog(graph, view, surfaces, shadows, level, stage.surroundings.ambient, image, settings.fog);
    if (settings.layers) surfaceLayers(graph, view, surfaces, layers);
    if (plan.on("antialias"))
        image = antialias(graph, view, surfaces, level.scene, image, {settings.size, plan.on("upscale")}, stage.gathered,
                          settings.layers ? &layers : nullptr);
    else if (plan.on("upscale"))
        image = upscale(graph, view, image, settings.size);
    settle(stage.level->scene);
    const Texture glare = plan.on("bloom") ? bloom(graph, image, settings.bloom) : image;
    return {image, display(graph, glare, settings.display), layers};
}
}
