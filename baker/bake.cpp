// The order of the stages, from a level's file to its baked folder.
#include "baker/atlas.hpp"
#include "baker/baker.hpp"
#include "baker/denoise.hpp"
#include "baker/dilate.hpp"
#include "baker/lightmap.hpp"
#include "baker/lod.hpp"
#include "baker/probes.hpp"
#include "baker/reflections.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include "engine/core/jobs.hpp"
#include "engine/core/log.hpp"
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
    int reflectionSize; // texels
    int reflectionSamples;
};
static constexpr Preset kPresets[] = {
    {"draft", 8.0f, 16e3f, 64, 2.0f, 4.0f, 256, 64, 32},
    {"medium", 16.0f, 64e3f, 256, 1.0f, 6.0f, 1024, 64, 64},
    {"high", 32.0f, 128e3f, 384, 0.5f, 10.0f, 4096, 128, 128},
};

int samplesOf(Quality quality) { return kPresets[int(quality)].samples; }

static double secondsSince(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Of the processor, all threads together: what a bake costs whoever else is using the machine.
static double cpuSecondsSince(std::clock_t start) { return double(std::clock() - start) / CLOCKS_PER_SEC; }

static void stopIfInterrupted(const Progress& progress)
{
    if (progress.interrupted()) throw Error("interrupted: nothing was written; run the same command again to bake", Exit::interrupted);
}

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

static bool calledFor(const std::vector<Need>& all, const char* stage, bool asked, json& reasons)
{
    const Need& found = need(all, stage);
    reasons[stage] = std::string(found.on && asked ? "on, " : "off, ") + (asked ? found.reason : "not in --only");
    return found.on && asked;
}

void bakeLevel(const std::filesystem::path& level, const std::filesystem::path& directory, const BakeOptions& options, Progress& progress)
{
    auto start = std::chrono::steady_clock::now();
    std::clock_t cpuStart = std::clock();
    if (std::filesystem::exists(directory) && !isBaked(directory))
        throw Error(directory.string() + " exists and is not a baked folder: choose another place, or remove it");
    const Preset& preset = kPresets[int(options.quality)];
    std::vector<std::uint8_t> bytes = readFile(level);
    Baked baked;
    baked.scene = loadLevel(level);
    requireWritable(directory);
    baked.directAll = options.directAll;
    std::vector<Need> wanted = needs(baked.scene, options.directAll);
    json manifest = {{"level", {{"path", level.filename().string()}, {"sha256", sha256(bytes.data(), bytes.size())}}}};
    json& products = manifest["products"];
    json& reasons = manifest["needs"];
    bool lightmaps = calledFor(wanted, "lightmaps", options.lightmaps, reasons),
         probes = calledFor(wanted, "probes", options.probes, reasons);
    bool reflections = calledFor(wanted, "reflections", options.reflections, reasons),
         lods = calledFor(wanted, "lods", options.lods, reasons);

    // Places in the lightmap pages
    Atlas atlas;
    AtlasOptions layout;
    layout.texelsPerMetre = options.texelsPerMetre.value_or(
        std::max(preset.texelsPerMetre, float(std::sqrt(double(preset.leastTexels) / std::max(staticArea(baked.scene), 1e-12)))));
    atlas.places.resize(baked.scene.objects.size());
    if (lightmaps) {
        progress.begin("atlas", 1, "levels");
        atlas = makeAtlas(baked.scene, layout);
        progress.advance(1);
        progress.end();
    }
    baked.places = atlas.places;

    // The level as light meets it: static objects only, and the lights that the bake is told of
    World world(baked.scene, Content::staticOnly);
    std::vector<Light> seen, direct;
    for (const Light& light : baked.scene.lights) {
        if (light.bake != kBakeNone || options.directAll) seen.push_back(light);
        if (light.bake == kBakeAll || options.directAll) direct.push_back(light);
    }
    LightTransport transport(world, seen);
    transport.limits.rouletteFrom = 1; // thousands of paths a texel: shorter ones, and more of them
    if (options.bounces) transport.limits.maxBounces = uint(std::max(*options.bounces, 0));
    BakeContext context(transport, direct, progress);
    context.seed = options.seed;
    context.threads = options.threads;

    auto timed = [&](const char* product, auto&& stage) {
        auto began = std::chrono::steady_clock::now();
        std::clock_t cpuBegan = std::clock();
        std::uint64_t before = context.rays;
        json row = stage();
        stopIfInterrupted(progress);
        row["seconds"] = secondsSince(began);
        row["cpu_seconds"] = cpuSecondsSince(cpuBegan);
        row["rays"] = context.rays - before;
        products[product] = row;
    };
    int samples = options.samples.value_or(preset.samples);
    if (lightmaps)
        timed("lightmaps", [&]() -> json {
            LightmapResult result = bakeLightmaps(context, atlas.places, atlas.pageSizes, samples);
            for (std::size_t p = 0; p < result.pages.size(); p++) {
                if (options.denoiser == Denoiser::builtin) denoise(result.pages[p], result.guides[p], options.threads);
                dilate(result.pages[p]);
            }
            baked.lightmaps = std::move(result.pages);
            return {{"texels", result.texels},
                    {"valid_texels", result.validTexels},
                    {"estimated_error", result.estimatedError},
                    {"utilisation", atlas.report.utilisation},
                    {"charts", atlas.report.charts},
                    {"texels_per_metre", atlas.report.texelsPerMetre},
                    {"samples", samples},
                    {"denoise", options.denoiser == Denoiser::builtin ? "builtin" : "none"}};
        });
    ProbesResult probed;
    vec3 extent = baked.scene.upper - baked.scene.lower;
    if (probes || reflections)
        timed("probes", [&]() -> json {
            float spacing = std::min(preset.spacing, largestOf(extent) / preset.leastProbes);
            probed = bakeProbes(context, placeProbes(baked.scene, spacing), preset.probeSamples);
            if (probes) baked.probes = probed.volumes;
            return {{"count", probed.count},
                    {"valid", probed.valid},
                    {"estimated_error", probed.estimatedError},
                    {"samples", preset.probeSamples}};
        });
    if (reflections)
        timed("reflections", [&]() -> json {
            baked.reflections = placeReflections(world, probed, /* most= */ 8);
            float error = bakeReflections(context, baked.reflections, preset.reflectionSize, preset.reflectionSamples);
            return {{"count", baked.reflections.size()},
                    {"estimated_error", error},
                    {"samples", preset.reflectionSamples},
                    {"size", preset.reflectionSize}};
        });
    if (lods)
        timed("lods", [&]() -> json {
            baked.lods = makeLods(baked.scene, LodOptions{}, options.threads);
            std::size_t levels = 0;
            for (const MeshLods& mesh : baked.lods)
                for (const auto& primitive : mesh.primitives) levels += primitive.size();
            return {{"levels", levels}};
        });

    double seconds = secondsSince(start);
    manifest["options"] = {{"quality", preset.name}, {"texels_per_metre", layout.texelsPerMetre},
                           {"samples", samples},     {"bounces", transport.limits.maxBounces},
                           {"seed", options.seed},   {"direct", options.directAll ? "all" : "as-said"}};
    manifest["seconds"] = seconds;
    manifest["cpu_seconds"] = cpuSecondsSince(cpuStart);
    manifest["rays"] = std::uint64_t(context.rays);
    manifest["rays_per_second"] = double(context.rays) / std::max(seconds, 1e-9);
    manifest["threads"] = threadCount(options.threads);
    manifest["dropped"] = baked.scene.dropped;
    manifest["warnings"] = baked.scene.warnings;
    for (const std::string& line : baked.scene.warnings) warning(line);
    writeBaked(directory, baked, manifest, options.exr);
}
}
