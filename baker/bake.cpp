// The order of the stages, from a level's file to its baked folder.
#include "baker/journal.hpp"
#include "baker/key.hpp"
#include "baker/light_layers.hpp"
#include "baker/memory.hpp"
#include "baker/oidn.hpp"
#include "baker/pace.hpp"
#include "baker/reckon.hpp"
#include "baker/stages.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include "engine/core/jobs.hpp"
#include "engine/core/log.hpp"
#include "engine/core/machine.hpp"
#include "engine/core/scaffold.hpp"
#include "engine/scene/needs.hpp"
#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

// What a quality stands for.
struct Preset {
    const char* name;
    float texelsPerMetre;
    float leastTexels; // a small level gets at least about as many in all, whatever its size in metres
    int samples;       // paths per texel
    float spacing;     // m between probes
    float leastProbes; // along the longest axis of a small level
    int probeSamples;
    float probeError;   // between probes, and of each
    int reflectionSize; // texels
    int reflectionSamples;
};

// Paths as many as leave no more noise behind the filter than texels of that size are off by themselves, in draft and medium (`./run bench
// --noise`): Cornell's box after the filter 4.9 % with 16 paths, 2.7 with 64, and its floor is 5 % off for the texels of draft, 2 for those of
// medium. High is to be looked at without a filter.
static constexpr Preset kPresets[] = {
    {"draft", 8.0f, 16e3f, 16, 2.0f, 4.0f, 128, 0.2f, 64, 32},
    {"medium", 16.0f, 64e3f, 64, 1.0f, 4.0f, 1024, 0.05f, 64, 64},
    {"high", 32.0f, 128e3f, 384, 1.0f, 4.0f, 2048, 0.03f, 128, 128},
};

static constexpr double kMostCells = 2e4;               // of an open level before its light is looked at
static constexpr std::uint64_t kProbeBytes = 32u << 20; // unless said otherwise

const char* nameOf(Denoiser denoiser) { return denoiser == Denoiser::none ? "none" : denoiser == Denoiser::builtin ? "builtin" : "oidn"; }

int samplesOf(Quality quality) { return kPresets[int(quality)].samples; }

static double secondsSince(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Of the processor, all threads together: what a bake costs whoever else is using the machine.
static double cpuSecondsSince(std::clock_t start) { return double(std::clock() - start) / CLOCKS_PER_SEC; }

// Area in m2 of everything that may carry a lightmap.
static double staticArea(const Scene& scene)
{
    double area = 0.0;
    for (const Instance& instance : instances(scene)) {
        if ((instance.flags & kInstanceStatic) == 0) continue;
        for (uint i = 0; i + 2 < instance.indexCount; i += 3) {
            vec3 p[3];
            for (uint k = 0; k < 3; k++)
                p[k] = instance.toWorld *
                       vec4(scene.vertices[instance.firstVertex + scene.indices[instance.firstIndex + i + k]].position, 1.0f);
            area += 0.5 * double(length(cross(p[1] - p[0], p[2] - p[0])));
        }
    }
    return area;
}

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

// The bake takes the whole folder's place: its level must not be lost with it.
static void refuseInside(const std::filesystem::path& level, const std::filesystem::path& place)
{
    const std::filesystem::path from = placeOf(level);
    if (std::mismatch(place.begin(), place.end(), from.begin(), from.end()).first == place.end())
        throw Error("the level " + level.string() + " lies in the output " + place.string() +
                        ", which the bake replaces; name another folder",
                    Exit::usage);
}

BakeOptions resolved(BakeOptions o, const Scene& scene)
{
    const Preset& preset = kPresets[int(o.quality)];
    const auto otherwise = [](auto& value, auto said) { value = value.value_or(said); };
    if (!o.texelsPerMetre)
        o.texelsPerMetre =
            std::max(preset.texelsPerMetre, float(std::sqrt(double(preset.leastTexels) / std::max(staticArea(scene), 1e-12))));
    otherwise(o.samples, preset.samples);
    // Who says how far probes stand apart means it; otherwise the light says
    otherwise(o.probeError, o.probeSpacing || !scene.probeVolumes.empty() ? 0.0f : preset.probeError);
    otherwise(o.probeBytes, kProbeBytes);
    otherwise(o.probeNoise, preset.probeError);
    const vec3 extent = scene.upper - scene.lower;
    otherwise(o.probeSpacing,
              float(spacingWithin(dvec3(extent), double(min(preset.spacing, largestOf(extent) / preset.leastProbes)), kMostCells)));
    otherwise(o.probeSamples, preset.probeSamples);
    otherwise(o.reflectionSize, preset.reflectionSize);
    otherwise(o.reflectionSamples, preset.reflectionSamples);
    otherwise(o.bounces, TruthOptions{}.bounces);
    o.lightCache = o.lightCache.value_or(o.denoiser != Denoiser::none) && !o.keeps() && *o.bounces >= kCachedBounces;
    return o;
}

// Of all reflection probes, six faces each.
static std::uint64_t cubeTexels(const Scene& scene, const BakeOptions& options)
{
    const std::size_t cubes = scene.reflectionProbes.empty() ? std::size_t(kMostReflections) : scene.reflectionProbes.size();
    return 6 * cubes * std::uint64_t(*options.reflectionSize) * std::uint64_t(*options.reflectionSize);
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
    bool lightmaps = calledFor(wanted, "lightmaps", options.lightmaps, reasons);
    bool directional = calledFor(wanted, "directional", options.lightmaps, reasons);
    if (options.directional && lightmaps && *options.directional != directional) {
        directional = *options.directional;
        reasons["directional"] = std::string(directional ? "on" : "off") + ", as --directional says";
    }
    bool probes = calledFor(wanted, "probes", options.probes, reasons);
    bool reflections = calledFor(wanted, "reflections", options.reflections, reasons);
    bool lods = calledFor(wanted, "lods", options.lods, reasons);
    bool voxels = calledFor(wanted, "voxels", options.voxels, reasons);
    const bool isChosen = only(options).size() < only(BakeOptions{}).size(); // by --only: what is not made is missed
    for (const std::string& product : only(options)) {
        const std::string reason = reasons[product];
        if (isChosen && reason.starts_with("off")) note("no " + product + " are baked: " + reason.substr(reason.find(' ') + 1));
    }

    BakeOptions made = options;
    made.lightmaps = lightmaps, made.probes = probes, made.reflections = reflections, made.lods = lods, made.voxels = voxels;
    LightLayers layers{scene, options.directAll, {}};
    if (options.lightLayers) layers.all = lightLayers(scene, options.directAll);
    progress.plan(reckoned(scene, made, staticArea(scene), std::max(layers.all.size(), std::size_t(1))));

    std::unique_ptr<Oidn> oidn; // before hours are spent: the machine may have none
    if (lightmaps && options.denoiser == Denoiser::oidn) oidn = std::make_unique<Oidn>(options.threads);
    Atlas atlas;
    atlas.places.resize(scene.objects.size());
    const Glow glow = glowOf(scene);
    if (options.lightLayers) setGlow(scene, white(glow)); // meshes are parted and solids found by where light falls, whatever its colours
    if (lightmaps) atlas = layOut(bake);
    bake.baked.places = atlas.places;

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
    context.directional = directional;
    context.caches = *options.lightCache;
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
                                        .directional = directional,
                                        .caches = lightmaps && context.caches,
                                        .layers = layerCount(context),
                                        .seamPoints = options.stitch ? std::uint64_t(seams.points.size()) : 0,
                                        .triangles = lods ? trianglesOf(scene) : 0,
                                        .parted = probes ? std::uint64_t(world.triangles().size()) : 0,
                                        .cubeTexels = reflections ? cubeTexels(scene, options) : 0,
                                        .voxels = voxels});
    const MemoryPlan plan = planMemory(memory, {memoryNow(), memoryPeak()}, options.maxMemory, journal != nullptr);
    context.streamed = plan.streamed || (journal && layerCount(context) > 1);
    if (plan.streamed) note(std::to_string(memory.light >> 20) + " MiB of light wait on the disk, as --max-memory says");
    manifest["memory"] = told(memory, plan, atlas.pageSizes, world);

    auto timed = [&](const char* product, Job job, auto&& stage) {
        auto began = std::chrono::steady_clock::now();
        std::clock_t cpuBegan = std::clock();
        const RayCount before = context.rays();
        json row = stage();
        const Spent earlier = journal ? journal->before(job) : Spent{};
        row["seconds"] = earlier.seconds + secondsSince(began);
        row["cpu_seconds"] = earlier.cpuSeconds + cpuSecondsSince(cpuBegan);
        const RayCount& now = context.rays();
        row["rays"] = now.all() - before.all();
        row["paths_cut"] = now.cut - before.cut;
        row["ray_kinds"] = {{"closest", now.closest - before.closest},
                            {"closest_packed", now.closestPacked - before.closestPacked},
                            {"shadow", now.shadow - before.shadow},
                            {"shadow_packed", now.shadowPacked - before.shadowPacked}};
        manifest["products"][product] = row;
    };
    if (lightmaps) timed("lightmaps", Job::lightmaps, [&] { return lightmapStage(bake, context, atlas, seams, oidn.get()); });
    if (probes) timed("probes", Job::probes, [&] { return probeStage(bake, context); });
    if (reflections) timed("reflections", Job::reflections, [&] { return reflectionStage(bake, context); });
    if (lods) timed("lods", Job::lods, [&] { return lodStage(bake, journal); });
    if (voxels) timed("voxels", Job::voxels, [&] { return voxelStage(bake); });

    manifest["options"] = {{"quality", kPresets[int(options.quality)].name},
                           {"texels_per_metre", *options.texelsPerMetre},
                           {"samples", *options.samples},
                           {"bounces", transport.limits.maxBounces},
                           {"seed", options.seed},
                           {"direct", options.directAll ? "all" : "as-said"},
                           {"only", only(options)},
                           {"directional", directional},
                           {"denoise", nameOf(options.denoiser)},
                           {"light_cache", *options.lightCache},
                           {"stitch", options.stitch}};
    if (options.targetError) manifest["options"]["target_error"] = *options.targetError;
    if (options.incremental) manifest["options"]["incremental"] = true;
    for (const LightLayer& layer : layers.all)
        manifest["light_layers"].push_back({{"name", layer.name}, {"strength", {layer.strength.x, layer.strength.y, layer.strength.z}}});
    manifest["rays"] = context.rays().all();
    manifest["threads"] = threadCount(options.threads);
    manifest["dropped"] = scene.dropped;
    manifest["warnings"] = scene.warnings;
    return std::move(bake.baked);
}

// What a bake keeps for the next one of its level, beside its folder: no other program needs it.
static std::filesystem::path leftBy(const std::filesystem::path& directory) { return bakedPlace(directory).string() + ".kept"; }

// What an earlier process chose stays chosen, whatever the clock would say now.
static BakeOptions pacedOnce(const Scene& scene, const BakeOptions& asked, Progress& progress, json& manifest, Journal& journal)
{
    json& told = manifest["time_budget"];
    BakeOptions kept = asked;
    if (const std::optional<Done> done = journal.recall({Job::pace})) {
        const json said = json::parse(done->bytes);
        told = said["told"];
        kept.quality = said["quality"], kept.samples = said["samples"], kept.texelsPerMetre = said["texels_per_metre"];
        return resolved(kept, scene);
    }
    kept = paced(scene, asked, *asked.timeBudget, progress, manifest);
    const std::string said =
        json{{"told", told}, {"quality", kept.quality}, {"samples", *kept.samples}, {"texels_per_metre", *kept.texelsPerMetre}}.dump();
    journal.keep({Job::pace}, {reinterpret_cast<const std::uint8_t*>(said.data()), said.size()}, {});
    return kept;
}

static void bakeLevel(const std::filesystem::path& level, const std::filesystem::path& directory, const BakeOptions& options,
                      Progress& progress, Journal& journal, json manifest)
{
    std::vector<std::uint8_t> bytes = readFile(level);
    manifest["level"] = {{"path", level.filename().string()}, {"sha256", sha256(bytes.data(), bytes.size())}};
    Scene scene = loadLevel(level);
    if (const std::string line = droppedText(scene); !line.empty()) note(line);
    for (const std::string& line : scene.warnings) warning(line);
    const double unpaced = journal.spent().seconds - journal.before(Job::pace).seconds;
    const BakeOptions kept = options.timeBudget ? pacedOnce(scene, options, progress, manifest, journal) : options;
    const double paced = journal.spent().seconds - unpaced; // trials of a time budget, whose rays are not counted
    const std::filesystem::path left = options.keeps() ? leftBy(directory) : std::filesystem::path();
    const std::unique_ptr<const Journal> earlier = std::filesystem::exists(left) ? std::make_unique<const Journal>(left) : nullptr;
    const Baked baked = bakeScene(std::move(scene), kept, progress, manifest, &journal, earlier.get());

    const Spent spent = journal.spent();
    manifest["memory"]["peak_bytes"] = memoryPeak();
    manifest["seconds"] = spent.seconds;
    manifest["cpu_seconds"] = spent.cpuSeconds;
    manifest["rays_per_second"] = manifest["rays"].get<double>() / std::max(spent.seconds - paced, 1e-9);
    progress.begin("writing", packedFiles(baked, options.exr), "files");
    writeBaked(directory, baked, manifest, options.exr, [&](std::uint64_t units) { progress.advance(units); });
    journal.finish(left);
    progress.end();
}

void bakeLevel(const std::filesystem::path& level, const std::filesystem::path& directory, const BakeOptions& options, Progress& progress)
{
    const std::filesystem::path place = bakedPlace(directory);
    refuseInside(level, place);
    requireWritableFolder(directory);
    const std::string key = bakeKey(level, options);
    if (!options.force && holdsBake(place, key))
        return note(place.string() + " is this bake already, of the same level and options: nothing is done; --force bakes it again");
    Journal journal(place, key, options.resume ? Journal::Start::resume : Journal::Start::afresh);
    try {
        bakeLevel(level, directory, options, progress, journal, {{"key", key}});
    } catch (const Error& error) {
        if (error.exit != Exit::interrupted || !journal.resumable()) throw;
        throw Error("interrupted: what was done is kept in " + place.string() +
                        ".journal; the same command with --resume goes on from there",
                    Exit::interrupted);
    }
}
}
