// The order of the stages, from a level to what is baked of it.
#include "baker/journal.hpp"
#include "baker/key.hpp"
#include "baker/learned_light.hpp"
#include "baker/light_layers.hpp"
#include "baker/memory.hpp"
#include "baker/oidn.hpp"
#include "baker/reckon.hpp"
#include "baker/stages.hpp"
#include "engine/core/error.hpp"
#include "engine/core/jobs.hpp"
#include "engine/core/log.hpp"
#include "engine/core/machine.hpp"
#include "engine/scene/needs.hpp"
#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

static double secondsSince(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Of the processor, all threads together: what a bake costs whoever else is using the machine.
static double cpuSecondsSince(std::clock_t start) { return double(std::clock() - start) / CLOCKS_PER_SEC; }

static std::vector<std::string> only(const BakeOptions& options)
{
    std::vector<std::string> names;
    for (auto [asked, name] : {std::pair(options.lightmaps, "lightmaps"),
                               {options.probes, "probes"},
                               {options.reflections, "reflections"},
                               {options.lods, "lods"},
                               {options.voxels, "voxels"}})
        if (asked) names.push_back(name);
    return names;
}

static bool calledFor(const std::vector<Need>& all, const char* stage, bool asked, json& reasons)
{
    const Need& found = need(all, stage);
    reasons[stage] = std::string(found.on && asked ? "on, " : "off, ") + (asked ? found.reason : "not in --only");
    return found.on && asked;
}

namespace
{
// What is made.
struct Products {
    bool lightmaps, directional, probes, reflections, lods, voxels;
};
}

// As asked for and called for; the reasons go to bake.json.
static Products productsOf(const std::vector<Need>& wanted, const BakeOptions& options, json& reasons)
{
    Products made;
    made.lightmaps = calledFor(wanted, "lightmaps", options.lightmaps, reasons);
    made.directional = calledFor(wanted, "directional", options.lightmaps, reasons);
    if (options.directional && made.lightmaps && *options.directional != made.directional) {
        made.directional = *options.directional;
        reasons["directional"] = std::string(made.directional ? "on" : "off") + ", as --directional says";
    }
    made.probes = calledFor(wanted, "probes", options.probes, reasons);
    made.reflections = calledFor(wanted, "reflections", options.reflections, reasons);
    made.lods = calledFor(wanted, "lods", options.lods, reasons);
    made.voxels = calledFor(wanted, "voxels", options.voxels, reasons);
    const bool isChosen = only(options).size() < only(BakeOptions{}).size(); // by --only: what is not made is missed
    for (const std::string& product : only(options)) {
        const std::string reason = reasons[product];
        if (isChosen && reason.starts_with("off")) note("no " + product + " are baked: " + reason.substr(reason.find(' ') + 1));
    }
    return made;
}

// Of all reflection probes, six faces each.
static std::uint64_t cubeTexels(const Scene& scene, const BakeOptions& options)
{
    const std::size_t cubes = scene.reflectionProbes.empty() ? std::size_t(kMostReflections) : scene.reflectionProbes.size();
    return 6 * cubes * std::uint64_t(*options.reflectionSize) * std::uint64_t(*options.reflectionSize);
}

// A stage's row, with what it took: of these jobs, earlier processes too.
static json measured(const BakeContext& context, const std::vector<Job>& jobs, const std::function<json()>& stage)
{
    const auto began = std::chrono::steady_clock::now();
    const std::clock_t cpuBegan = std::clock();
    const RayCount before = context.rays();
    json row = stage();
    double seconds = secondsSince(began), cpuSeconds = cpuSecondsSince(cpuBegan);
    for (const Job job : jobs)
        if (context.journal) seconds += context.journal->before(job).seconds, cpuSeconds += context.journal->before(job).cpuSeconds;
    row["seconds"] = seconds;
    row["cpu_seconds"] = cpuSeconds;
    const RayCount& now = context.rays();
    row["rays"] = now.all() - before.all();
    row["paths_cut"] = now.cut - before.cut;
    row["paths_not_finite"] = now.notFinite - before.notFinite;
    row["ray_kinds"] = {{"closest", now.closest - before.closest},
                        {"closest_packed", now.closestPacked - before.closestPacked},
                        {"shadow", now.shadow - before.shadow},
                        {"shadow_packed", now.shadowPacked - before.shadowPacked}};
    return row;
}

// As bake.json says what was asked for.
static json askedFor(const BakeOptions& options, uint bounces, bool directional)
{
    json asked = {{"quality", nameOf(options.quality)},
                  {"texels_per_metre", *options.texelsPerMetre},
                  {"samples", *options.samples},
                  {"bounces", bounces},
                  {"seed", options.seed},
                  {"direct", options.directAll ? "all" : "as-said"},
                  {"only", only(options)},
                  {"directional", directional},
                  {"denoise", nameOf(options.denoiser)},
                  {"light_cache", *options.lightCache},
                  {"stitch", options.stitch}};
    if (options.targetError) asked["target_error"] = *options.targetError;
    if (options.incremental) asked["incremental"] = true;
    return asked;
}

Baked bakeScene(Scene level, const BakeOptions& asked, Progress& progress, json& manifest, Journal* journal, const Journal* earlier)
{
    const BakeOptions options = resolved(asked, level);
    Bake bake{options, progress, {}};
    bake.baked.scene = std::move(level);
    bake.baked.directAll = options.directAll;
    Scene& scene = bake.baked.scene;
    bake.told = scene.warnings.size(); // by whoever loaded it
    json& reasons = manifest["needs"];
    std::vector<Need> wanted = needs(scene, options.directAll);
    const auto [lightmaps, directional, probes, reflections, lods, voxels] = productsOf(wanted, options, reasons);

    BakeOptions made = options;
    const double area = staticArea(scene);
    const float learnedAt = need(wanted, "lightmaps").on ? learnedDensity(scene, options, area) : 0.0f; // texels per metre
    const bool learns = probes && !lightmaps && *options.lightCache && learnedAt > 0.0f;
    made.lightCache = *options.lightCache && (lightmaps || learns);
    made.lightmaps = lightmaps, made.probes = probes, made.reflections = reflections, made.lods = lods, made.voxels = voxels;
    LightLayers layers{scene, options.directAll, {}};
    if (options.lightLayers) layers.all = lightLayers(scene, options.directAll);
    progress.plan(reckoned(scene, made, area, std::max(layers.all.size(), std::size_t(1))));

    std::unique_ptr<Oidn> oidn; // before hours are spent: the machine may have none
    if (lightmaps && options.denoiser == Denoiser::oidn) oidn = std::make_unique<Oidn>(options.threads);
    Atlas atlas;
    const Glow glow = glowOf(scene);
    if (options.lightLayers) setGlow(scene, white(glow)); // meshes are parted and solids found by where light falls, whatever its colours
    Uncharted uncharted;
    if (learns) {
        uncharted = chartedOf(scene);
        for (Object& object : scene.objects) object.texelsPerMetre = std::min(object.texelsPerMetre, learnedAt);
    }
    if (lightmaps || learns) atlas = layOut(bake, learns ? learnedAt : *options.texelsPerMetre);
    if (lightmaps) tellWarnings(bake); // those of charts that nobody gets are not told
    bake.baked.places = lightmaps ? atlas.places : std::vector<LightmapPlace>(scene.objects.size());

    // The level as light meets it: static objects only, and the lights that the bake is told of
    World world(scene, Content::staticOnly);
    const Solids solids(LightTransport(world, bakedLights(scene.lights, options.directAll).seen));
    setGlow(scene, glow);
    const BakedLights lights = bakedLights(scene.lights, options.directAll);
    LightTransport transport(world, lights.seen);
    transport.limits.rouletteFrom = 1; // hundreds of paths a texel: shorter ones, and more of them
    transport.limits.maxBounces = uint(std::max(*options.bounces, 0));
    BakeContext context(transport, solids, lights.direct, progress);
    context.seed = options.seed;
    context.threads = options.threads;
    context.journal = journal;
    context.directional = directional || (learns && need(wanted, "directional").on);
    context.caches = *made.lightCache;
    context.earlier = earlier;
    if (options.keeps() && lightmaps) {
        const LayerKeys keys(scene, atlas, solids, options, directional);
        for (LightLayer& layer : layers.all) layer.key = keys.of(layer.glow), layer.seed = layerSeed(layer.glow, options.seed);
        if (options.lightLayers)
            context.layers = &layers;
        else
            context.layer = keys.of(glow);
    }

    Seams seams; // before the plan: they stay in memory as long as the lightmaps are made
    if (lightmaps) seams = findSeams(world, atlas.places, atlas.pageSizes, options.threads);
    const BakeMemory memory = memoryOf({.pages = atlas.pageSizes,
                                        .directional = context.directional,
                                        .caches = context.caches,
                                        .written = lightmaps,
                                        .layers = layerCount(context),
                                        .seamPoints = options.stitch ? std::uint64_t(seams.points.size()) : 0,
                                        .triangles = lods ? trianglesOf(scene) : 0,
                                        .parted = probes ? std::uint64_t(world.triangles().size()) : 0,
                                        .cubeTexels = reflections ? cubeTexels(scene, options) : 0,
                                        .voxels = voxels,
                                        .threads = threadCount(options.threads)});
    const MemoryPlan plan = planMemory(memory, {memoryNow(), memoryPeak()}, options.maxMemory, journal != nullptr);
    context.streamed = plan.streamed || (journal && layerCount(context) > 1);
    if (plan.streamed) note(std::to_string(memory.light >> 20) + " MiB of light wait on the disk, as --max-memory says");
    manifest["memory"] = told(memory, plan, lightmaps ? atlas.pageSizes : std::vector<ivec2>(), world);

    const auto timed = [&](const char* product, const std::vector<Job>& jobs, auto&& stage) {
        manifest["products"][product] = measured(context, jobs, stage);
    };
    if (lightmaps) timed("lightmaps", {Job::lightmaps}, [&] { return lightmapStage(bake, context, atlas, seams, oidn.get()); });
    std::vector<Job> ofProbes{Job::probes};
    if (learns) ofProbes.push_back(Job::lightmaps); // whose paths they are
    if (probes)
        timed("probes", ofProbes, [&] {
            if (learns) learnLight(context, atlas.places, atlas.pageSizes, learnedOf(options.quality));
            json product = probeStage(bake, context);
            if (learns) product["learned"] = {{"texels_per_metre", learnedAt}, {"samples", learnedOf(options.quality)}};
            return product;
        });
    if (reflections) timed("reflections", {Job::reflections}, [&] { return reflectionStage(bake, context); });
    if (learns) chartedOf(scene) = std::move(uncharted); // no path is traced from here on
    if (lods) timed("lods", {Job::lods}, [&] { return lodStage(bake, journal); });
    if (voxels) timed("voxels", {Job::voxels}, [&] { return voxelStage(bake); });

    manifest["options"] = askedFor(options, transport.limits.maxBounces, directional);
    for (const LightLayer& layer : layers.all)
        manifest["light_layers"].push_back({{"name", layer.name}, {"strength", {layer.strength.x, layer.strength.y, layer.strength.z}}});
    manifest["rays"] = context.rays().all();
    manifest["threads"] = threadCount(options.threads);
    manifest["dropped"] = scene.dropped;
    manifest["warnings"] = scene.warnings;
    return std::move(bake.baked);
}
}
