// A level made ready: only what the plan calls for is uploaded.
#include "engine/effects/jitter.h"
#include "engine/frame/frame.hpp"
#include <cmath>

namespace afterglow
{
constexpr float kSharperTextures = -1.0f; // mips: 16 samples of half a pixel's texels cover the pixel
constexpr float kGatheredSamples = 16.0f; // in a shown pixel of a written picture

Settings adoptLevel(Settings asked, const Scene& scene)
{
    asked.bloom.strength = scene.display.bloom;
    asked.display.exposureEv = scene.display.exposureEv;
    asked.display.curve = scene.display.curve;
    return asked;
}

static float scaleOf(const Plan& plan, const Settings& settings) { return plan.on("upscale") ? settings.renderScale : 1.0f; }

View nextView(const Stage& stage, const Camera& camera, const Settings& settings)
{
    FrameSample sample;
    const float scale = scaleOf(stage.plan, settings);
    sample.drawn = max(uvec2(round(vec2(settings.size) * scale)), 1u);
    if (stage.plan.on("antialias")) {
        sample.frame = stage.gathered.frames;
        sample.jitter = jitterOf(sample.frame);
        sample.textureBias = kSharperTextures + std::log2(scale);
    }
    return makeView(camera, settings.size, sample);
}

void move(Stage& stage, uint object, const mat4& toWorld)
{
    move(stage.level->scene, object, toWorld);
    stage.shadows.drawn = false;
}

int framesOf(const Plan& plan, const Settings& settings)
{
    if (!plan.on("antialias")) return 1;
    const float scale = scaleOf(plan, settings);
    return int(std::ceil(kGatheredSamples / (scale * scale)));
}

Stage makeStage(Gpu& gpu, const Scene& scene, const Baked* baked, const Settings& settings)
{
    Stage stage;
    stage.plan = plan(needs(scene, baked && baked->directAll), evidenceOf(scene, baked, settings.renderScale), settings.effects);
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
