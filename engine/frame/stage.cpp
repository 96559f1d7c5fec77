// A level made ready: only what the plan calls for is uploaded.
#include "engine/frame/frame.hpp"

namespace afterglow
{
Settings adoptLevel(Settings asked, const Scene& scene)
{
    asked.display.exposureEv = scene.display.exposureEv;
    asked.display.curve = scene.display.curve;
    return asked;
}

// As asked for, or what comes next where the device has no ray queries.
static void chooseMethods(Stage& stage, const Device& device, const Settings& settings)
{
    stage.shadowMethod = settings.shadowMethod;
    if (stage.shadowMethod == ShadowMethod::map || device.rayQuery) return;
    stage.shadowMethod = ShadowMethod::map;
    stage.notes.push_back("--shadows ray: " + device.deviceName + " has no ray queries, so shadow maps are drawn instead");
}

Stage makeStage(Gpu& gpu, const Scene& scene, const Baked* baked, const Settings& settings)
{
    Stage stage;
    Evidence evidence = evidenceOf(scene, baked);
    evidence.tracedShadows = settings.shadowMethod == ShadowMethod::ray && gpu.device.rayQuery;
    stage.plan = plan(needs(scene, baked && baked->directAll), evidence, settings.effects);
    stage.notes = stage.plan.notes;
    chooseMethods(stage, gpu.device, settings);
    const bool lit = stage.plan.on("shadow"), tracedLights = lit && stage.shadowMethod == ShadowMethod::ray;
    const BakedParts parts{stage.plan.on("lightmaps"), stage.plan.on("probes"), stage.plan.on("reflections")};
    const std::vector<Instance> placed = baked ? placedInstances(*baked) : instances(scene);
    const std::vector<Light> lights = runtimeLights(scene, baked != nullptr, baked && baked->directAll);
    GpuScene uploaded = uploadScene(gpu, scene, placed, lights);
    if (tracedLights && !lights.empty()) uploaded.rays = buildRays(gpu, scene, placed);
    stage.level = std::make_unique<GpuLevel>(gpu, std::move(uploaded), baked ? uploadBaked(gpu, *baked, parts) : GpuBaked{});
    // Rays know the surfaces in the G-buffer: the air and what is drawn over them keep the maps
    if (lit && (!tracedLights || stage.plan.on("fog") || stage.plan.on("clear"))) {
        const SunMaps sun = stage.plan.on("shadow.cascades") ? SunMaps::cascades : SunMaps::level;
        stage.shadows = makeShadowMaps(gpu, stage.level->scene, settings.shadow, sun);
    }
    for (const DrawItem& item : stage.level->scene.draws) stage.emission |= item.emits && item.kind != DrawKind::clear;

    stage.surroundings = {meanSky(scene.sky), scene.sky.radiance, scene.sky.rotation};
    if (!baked)
        stage.notes.push_back("the level is not baked: it is lit by its direct light and a constant ambient from its sky; "
                              "`afterglow bake` adds what bounces");
    return stage;
}
}
