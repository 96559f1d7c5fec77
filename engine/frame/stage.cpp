// A level made ready: only what the plan calls for is uploaded.
#include "engine/baked/probe_cell.hpp"
#include "engine/core/error.hpp"
#include "engine/effects/jitter.h"
#include "engine/effects/probe_view/probe_view.hpp"
#include "engine/frame/frame.hpp"
#include "engine/upload/storage.hpp"
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
    asked.toon.everyone = asked.toonSteps.has_value() ? 1u : 0u;
    asked.toon.steps = asked.toonSteps.value_or(uint(scene.display.toonSteps));
    asked.outline.width = asked.outlineWidth.value_or(scene.display.outlinePixels);
    asked.outline.color = scene.display.outlineColor;
    if (scene.display.outlineCrease) asked.outline.creaseAngle = *scene.display.outlineCrease;
    return asked;
}

float occlusionRange(const Settings& settings, const ProbeTree* probes)
{
    const float range = settings.occlusion.range;
    return settings.occlusionRange.value_or(probes ? std::min(range, meanCellEdge(*probes)) : range);
}

// As asked for, or what comes next where the device has no ray queries.
static void chooseMethods(Stage& stage, const Device& device, const Settings& settings)
{
    stage.shadowMethod = settings.shadowMethod;
    stage.occlusionMethod = settings.occlusionMethod;
    stage.reflectionMethod = settings.reflectionMethod;
    if (device.rayQuery) return;
    const auto instead = [&](const std::string& option, const std::string& what) {
        stage.notes.push_back(option + " ray: " + device.deviceName + " has no ray queries, so " + what + " instead");
    };
    if (stage.shadowMethod == ShadowMethod::ray) {
        stage.shadowMethod = ShadowMethod::map;
        instead("--shadows", "shadow maps are drawn");
    }
    if (stage.occlusionMethod == OcclusionMethod::ray) {
        stage.occlusionMethod = OcclusionMethod::hbao;
        instead("--ao", "hbao is drawn");
    }
    if (stage.reflectionMethod == ReflectionMethod::ray) {
        stage.reflectionMethod = ReflectionMethod::screen;
        instead("--reflections", "the picture itself is mirrored");
    }
}

static float scaleOf(const Plan& plan, const Settings& settings) { return plan.on("upscale") ? settings.renderScale : 1.0f; }

View nextView(const Stage& stage, const Camera& camera, const Settings& settings)
{
    FrameSample sample;
    const float scale = scaleOf(stage.plan, settings);
    sample.drawn = max(uvec2(round(vec2(settings.size) * scale)), 1u);
    if (stage.plan.on("lods")) sample.mayStray = settings.lodError;
    if (stage.plan.on("antialias")) {
        sample.frame = stage.gathered.frames;
        sample.jitter = jitterOf(sample.frame);
        sample.textureBias = kSharperTextures + std::log2(scale);
    }
    return makeView(camera, settings.size, sample);
}

// Those whose effect is on.
static Flats flatsOf(const Plan& plan, const Scene& scene)
{
    Flats flats;
    if (plan.on("planar") || plan.on("portal")) flats = findFlats(scene);
    if (!plan.on("planar")) flats.mirrors.clear();
    if (!plan.on("portal")) flats.portals.clear();
    return flats;
}

void move(Gpu& gpu, Stage& stage, const Scene& scene, uint object)
{
    const mat4 toWorld(scene.objects[object].toWorld);
    move(stage.level->scene, object, toWorld);
    move(gpu, stage.level->scene.rays, object, toWorld);
    stage.flats = flatsOf(stage.plan, scene);
    stage.shadows.drawn = false;
    stage.traced.count = 0;
    stage.fog = {};
}

void forget(Stage& stage)
{
    stage.traced.count = 0;
    stage.gathered = {};
    stage.lastEye.reset();
    stage.fog = {};
}

int framesOf(const Plan& plan, const Settings& settings)
{
    if (settings.mode == Mode::truth) return int((settings.truth.samples + settings.truth.perFrame - 1) / settings.truth.perFrame);
    if (!plan.on("antialias")) return 1;
    const float scale = scaleOf(plan, settings);
    return int(std::ceil(kGatheredSamples / (scale * scale)));
}

// What is to be shown must be there.
static void demandShown(const Stage& stage, uint shown)
{
    const GpuBaked& baked = stage.level->baked;
    if (shown == kShowInfluence && baked.reflections.empty())
        throw Error("--show influence: there are no reflection probes: name a baked folder that holds some, and leave them on",
                    Exit::usage);
    if (shown != kShowNothing && shown != kShowInfluence && !baked.probeTree)
        throw Error("--show: there are no irradiance probes: name a baked folder that holds some, and leave them on", Exit::usage);
}

Stage makeStage(Gpu& gpu, const Scene& scene, const Baked* baked, const Settings& settings)
{
    Stage stage;
    if (settings.mode != Mode::raster) stage.tracing = tracingOn(gpu.device, settings.tracing);
    chooseMethods(stage, gpu.device, settings);
    Settings able = settings;
    able.shadowMethod = stage.shadowMethod, able.occlusionMethod = stage.occlusionMethod, able.reflectionMethod = stage.reflectionMethod;
    stage.plan = plan(needs(scene, baked && baked->directAll), evidenceOf(scene, baked, able), settings.effects);
    if (settings.mode == Mode::truth)
        leaveToPaths(stage.plan);
    else
        noteIdleKnobs(stage.plan, settings);
    stage.notes.insert(stage.notes.begin(), stage.plan.notes.begin(), stage.plan.notes.end());
    stage.occlusionRange = occlusionRange(settings, baked && stage.plan.on("probes") ? &baked->probes : nullptr);
    const bool lit = stage.plan.on("shadow"), tracedLights = lit && stage.shadowMethod == ShadowMethod::ray;
    const bool tracedContact = stage.plan.on("occlusion") && stage.occlusionMethod == OcclusionMethod::ray;
    const bool tracedMirrors = stage.plan.on("reflection") && stage.reflectionMethod == ReflectionMethod::ray;
    const BakedParts parts{stage.plan.on("lightmaps"), stage.plan.on("probes"), stage.plan.on("reflections"), stage.plan.on("directional")};
    const std::vector<Instance> placed = baked ? placedInstances(*baked) : instances(scene);
    const std::vector<Light> lights = runtimeLights(scene, baked != nullptr, baked && baked->directAll);
    const std::vector<MeshLods> finestOnly, &lods = stage.plan.on("lods") && baked ? baked->lods : finestOnly;
    GpuScene uploaded = uploadScene(gpu, scene, placed, lights, lods);
    if (settings.mode != Mode::truth) findClosedBodies(uploaded, scene);
    if (settings.mode != Mode::raster) {
        uploaded.rays = buildRays(gpu, scene, placed, RaysFor::paths);
        stage.paths = uploadPaths(gpu, scene, placed, uploaded.rays);
        stage.memory = &gpu.memory;
    } else if ((tracedLights && !lights.empty()) || tracedContact || tracedMirrors) {
        uploaded.rays = buildRays(gpu, scene, placed);
    }
    stage.level = std::make_unique<GpuLevel>(gpu, std::move(uploaded), baked ? uploadBaked(gpu, *baked, parts) : GpuBaked{});
    if (settings.mode != Mode::truth) demandShown(stage, settings.show);
    if (showsSpheres(settings.show)) stage.marks = storage(gpu, "probe marks", probeMarks(baked->probes));
    stage.flats = flatsOf(stage.plan, scene);
    if (lit && (!tracedLights || !keptMaps(stage.plan).empty())) {
        const SunMaps sun = stage.plan.on("shadow.cascades") ? SunMaps::cascades : SunMaps::level;
        stage.shadows = makeShadowMaps(gpu, stage.level->scene, settings.shadow, sun);
    }
    for (const DrawItem& item : stage.level->scene.draws) {
        stage.emission |= item.emits && item.kind != DrawKind::clear;
        stage.roughMetals |= item.roughMetal && item.kind != DrawKind::clear;
    }
    if (stage.plan.on("toon")) stage.ramps = toonRamps(scene, settings.toon);
    if (stage.plan.on("outline") && settings.outline.width > 0.0f)
        stage.edges = uploadEdges(gpu, scene, stage.level->scene.draws, settings.outline.creaseAngle);

    if (stage.plan.on("occlusion") && stage.occlusionMethod == OcclusionMethod::voxel)
        stage.voxels = uploadVoxels(gpu, baked && !baked->voxels.closed.empty() ? baked->voxels : voxelize(scene, /* staticOnly= */ false));

    stage.surroundings = {meanSky(scene.sky), scene.sky.radiance, scene.sky.rotation};
    if (!baked && settings.mode != Mode::truth)
        stage.notes.push_back("the level is not baked: it is lit by its direct light and a constant ambient from its sky; "
                              "`afterglow bake` adds what bounces");
    else if (baked && baked->probes.empty() && stage.plan.on("fog") && settings.mode != Mode::truth)
        stage.notes.push_back(
            "fog is lit by a constant ambient from the sky, indoors too, for the bake holds no irradiance probes: bake them, "
            "or leave fog out by --effects -fog");
    return stage;
}
}
