// A level made ready: only what the plan calls for is uploaded.
#include "engine/frame/frame.hpp"

namespace afterglow
{
Settings adoptLevel(Settings asked, const Scene& scene)
{
    asked.bloom.strength = scene.display.bloom;
    asked.display.exposureEv = scene.display.exposureEv;
    asked.display.curve = scene.display.curve;
    return asked;
}

Stage makeStage(Gpu& gpu, const Scene& scene, const Baked* baked, const Settings& settings)
{
    Stage stage;
    stage.plan = plan(needs(scene, baked && baked->directAll), evidenceOf(scene, baked), settings.effects);
    stage.notes = stage.plan.notes;
    const BakedParts parts{stage.plan.on("lightmaps"), stage.plan.on("probes"), stage.plan.on("reflections")};
    const std::vector<Instance> placed = baked ? placedInstances(*baked) : instances(scene);
    const std::vector<Light> lights = runtimeLights(scene, baked != nullptr, baked && baked->directAll);
    stage.level =
        std::make_unique<GpuLevel>(gpu, uploadScene(gpu, scene, placed, lights), baked ? uploadBaked(gpu, *baked, parts) : GpuBaked{});
    for (const DrawItem& item : stage.level->scene.draws) stage.emission |= item.emits && item.kind != DrawKind::clear;
    const SunMaps sun = stage.plan.on("shadow.cascades") ? SunMaps::cascades : SunMaps::level;
    if (stage.plan.on("shadow")) stage.shadows = makeShadowMaps(gpu, stage.level->scene, settings.shadow, sun);

    stage.surroundings = {meanSky(scene.sky), scene.sky.radiance, scene.sky.rotation};
    if (!baked)
        stage.notes.push_back("the level is not baked: it is lit by its direct light and a constant ambient from its sky; "
                              "`afterglow bake` adds what bounces");
    return stage;
}
}
