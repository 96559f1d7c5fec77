#include "baker/stages.hpp"
#include "baker/denoise.hpp"
#include "baker/dilate.hpp"
#include "baker/fireflies.hpp"
#include "baker/lod.hpp"
#include "baker/parting.hpp"
#include "baker/reflection_places.hpp"
#include "baker/reflections.hpp"
#include "baker/rounds.hpp"
#include "baker/stitch.hpp"
#include "baker/tile.hpp"
#include "engine/core/log.hpp"
#include "shaders/color.h"
#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

std::uint64_t trianglesOf(const Scene& scene)
{
    std::uint64_t triangles = 0;
    for (const Mesh& mesh : scene.meshes)
        for (const Primitive& primitive : mesh.primitives) triangles += primitive.indexCount / 3;
    return triangles;
}

double staticArea(const Scene& scene)
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

void tellWarnings(Bake& bake)
{
    const std::vector<std::string>& warnings = bake.baked.scene.warnings;
    for (; bake.told < warnings.size(); bake.told++) warning(warnings[bake.told]);
}

Atlas layOut(Bake& bake, float texelsPerMetre)
{
    Scene& scene = bake.baked.scene;
    AtlasOptions layout;
    layout.texelsPerMetre = texelsPerMetre;
    layout.pages = bake.options.lightmapPages.value_or(0);
    bake.progress.begin("atlas", trianglesOf(scene), "triangles");
    layout.pieces = partMeshes(scene, double(layout.texelsPerMetre), bake.options.threads);
    Atlas atlas = makeAtlas(scene, layout, bake.advance());
    bake.progress.end();
    return atlas;
}

namespace
{
// What a filter was given, and what it says of what it made.
struct Filtered {
    double brought = 0.0, left = 0.0; // luminance of all baked texels, before and after
    double squares = 0.0;             // of the error that is left: the mean of the channels, over the texels
    double total = 0.0, texels = 0.0; // of the means of the channels

    static double lightOf(const Lightmap& page)
    {
        double sum = 0.0;
        for (std::size_t i = 0; i < page.texels.size(); i++)
            if (page.valid[i] == 1) sum += double(luminance(page.texels[i]));
        return sum;
    }
    void before(const Lightmap& page) { brought += lightOf(page); }
    void after(const Lightmap& page, const TexelGuides& guides)
    {
        left += lightOf(page);
        for (std::size_t i = 0; i < page.texels.size(); i++)
            if (page.valid[i] == 1) squares += double(guides.variance[i]), total += grey(dvec3(page.texels[i])), texels += 1.0;
    }
    double kept() const { return brought > 0.0 ? left / brought : 1.0; }
    double relative() const { return total > 0.0 ? std::sqrt(squares / texels) / (total / texels) : 0.0; } // RMSE of a texel
};
}

static json told(const SeamSteps& steps) { return {{"mean", steps.mean}, {"p95", steps.most}, {"worst", steps.worst}}; }

// What is left of the seams of all pages, and what there was of them; in steps of a display.
static json stitchSeams(Bake& bake, const BakeContext& context, Seams& seams)
{
    std::vector<Lightmap>& pages = bake.baked.lightmaps;
    const std::size_t turning = dropParted(seams, sightIn(context.transport.world), context.solids, bake.options.threads);
    const Shown shown = shownAs(bake.baked.scene.display, pages);
    json product = {{"points", seams.points.size()}, {"points_turning", turning}, {"exposure", shown.exposure}};
    if (bake.options.stitch) {
        product["step_unstitched"] = told(stepsOf(pages, seams, shown));
        stitch(pages, seams, shown, bake.options.threads);
    }
    product["step"] = told(stepsOf(pages, seams, shown));
    return product;
}

// What spread fireflies are off by, to what a filter states: the built-in one of a channel, the mean, the other of luminance.
static void addOff(const std::vector<float>& off, const Islands& islands, const Lightmap& page, bool ofChannels, TexelGuides& guides)
{
    for (std::size_t texel = 0; texel < islands.of.size(); texel++) {
        const vec3 light = page.texels[texel];
        const float square = ofChannels ? dot(light, light) / 3.0f : luminance(light) * luminance(light);
        guides.variance[texel] += off[std::size_t(islands.of[texel])] * square;
    }
}

json lightmapStage(Bake& bake, BakeContext& context, const Atlas& atlas, Seams& seams, const Oidn* oidn)
{
    const std::optional<float> target = bake.options.targetError;
    const bool filtered = bake.options.denoiser != Denoiser::none;
    const Owners owners = findOwners(context.transport.world, atlas.places, atlas.pageSizes);
    std::vector<Lightmap>& pages = bake.baked.lightmaps;
    Filtered light;
    std::uint64_t work = 0; // of the filter
    for (ivec2 size : atlas.pageSizes) work += oidn ? 0 : denoiseRows(size.y);
    const auto finish = [&](Lightmap page, TexelGuides& guides) {
        light.before(page);
        if (filtered) {
            const Islands islands = islandsOf(page, guides, sightIn(context.transport.world));
            if (oidn) work += std::uint64_t(islands.count); // of the next pages it is not known yet
            if (pages.empty())
                bake.progress.begin("denoise", work, oidn ? "charts" : "rows");
            else
                bake.progress.expect(work);
            const std::vector<float> off = spreadFireflies(page, guides, islands);
            if (oidn)
                denoise(page, guides, islands, *oidn, bake.advance());
            else
                denoise(page, guides, islands, bake.options.threads, bake.advance());
            addOff(off, islands, page, /* ofChannels= */ !oidn, guides);
        }
        light.after(page, guides);
        const std::vector<uint>& owner = owners.texelOf[pages.size()];
        remember(seams, uint(pages.size()), page, guides, owner);
        dilate(page, owner);
        pages.push_back(std::move(page));
    };
    const LightmapResult result = bakeLightmaps(context, atlas.places, atlas.pageSizes, {*bake.options.samples, target}, finish);
    if (filtered && !pages.empty()) bake.progress.end();
    const json stitched = stitchSeams(bake, context, seams);
    if (target && result.estimatedError > *target)
        warning(fmt::format("--target-error {} is not reached: {:.3g} with {} paths in every texel, the most there are", *target,
                            result.estimatedError, kMostSamples));
    json product{{"texels", result.texels},
                 {"valid_texels", result.validTexels},
                 {"utilisation", atlas.report.utilisation},
                 {"charts", atlas.report.charts},
                 {"stretch", atlas.report.stretch},
                 {"texels_per_metre", atlas.report.texelsPerMetre},
                 {"samples", result.samples},
                 {"kept", result.kept},
                 {"denoise", nameOf(bake.options.denoiser)},
                 {"denoise_kept", light.kept()},
                 {"seams", stitched},
                 {"paths_clamped", 0}};
    if (result.samples < 2.0) return product; // one path tells nothing of its error
    product["estimated_error"] = result.estimatedError;
    if (filtered && !oidn) product["filtered_error"] = light.relative();
    return product;
}

static ProbeEffort effortOf(const BakeOptions& options)
{
    return {.spacing = double(*options.probeSpacing),
            .samples = *options.probeSamples,
            .noise = double(*options.probeNoise),
            .error = double(*options.probeError),
            .bytes = *options.probeBytes,
            .memory = options.maxMemory,
            .order = options.probeOrder,
            .walls = options.probeWalls};
}

// Probes that stand elsewhere than at a corner of their cell, by why they do.
static json movedFor(const std::vector<ProbeStand>& stands)
{
    json moved = json::object();
    for (const auto& [name, stand] : {std::pair("slanted", ProbeStand::slanted),
                                      {"buried", ProbeStand::buried},
                                      {"hidden", ProbeStand::hidden},
                                      {"near", ProbeStand::near},
                                      {"lamp", ProbeStand::lamp}})
        moved[name] = std::count(stands.begin(), stands.end(), stand);
    return moved;
}

json probeStage(Bake& bake, BakeContext& context)
{
    const ProbesResult probed = bakeProbes(context, effortOf(bake.options));
    bake.baked.probes = probed.tree;
    json product = {{"count", probed.tree.probes.size()},
                    {"cells", probed.tree.cells.size()},
                    {"moved", probed.tree.stands.size() -
                                  std::size_t(std::count(probed.tree.stands.begin(), probed.tree.stands.end(), ProbeStand::corner))},
                    {"moved_for", movedFor(probed.tree.stands)},
                    {"order", probed.tree.order},
                    {"estimated_error", probed.estimatedError},
                    {"samples", probed.samples},
                    {"unpacked_bytes", bytesOf(probed.tree)}};
    if (probed.interpolationError > 0.0f) product["interpolation_error"] = probed.interpolationError;
    return product;
}

static json toldOf(std::optional<float> known) { return known ? json(*known) : json(nullptr); }

json reflectionStage(Bake& bake, BakeContext& context)
{
    const auto began = std::chrono::steady_clock::now();
    PlacedReflections placed = placeReflections(context, kMostReflections);
    const double placing = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    std::vector<ReflectionProbe>& probes = bake.baked.reflections;
    probes = std::move(placed.probes);
    if (probes.empty()) note("no reflection probe is baked: no glossy surface lies in the open; place one by ag_reflection_probe");
    const float error = bakeReflections(context, probes, *bake.options.reflectionSize, *bake.options.reflectionSamples);
    json boxErrors = json::array(); // radians, of each
    for (const std::optional<float>& boxError : placed.boxErrors) boxErrors.push_back(toldOf(boxError));
    return {{"count", probes.size()},
            {"estimated_error", error},
            {"box_errors", boxErrors},
            {"place_error", toldOf(placed.error)},
            {"place_seconds", placing},
            {"samples", *bake.options.reflectionSamples},
            {"size", *bake.options.reflectionSize}};
}

json lodStage(Bake& bake, Journal* journal)
{
    bake.progress.begin("lods", trianglesOf(bake.baked.scene), "triangles");
    bake.baked.lods = makeLods(bake.baked.scene, LodOptions{}, bake.options.threads, bake.advance(), journal);
    bake.progress.end();
    std::size_t levels = 0;
    for (const MeshLods& mesh : bake.baked.lods)
        for (const auto& primitive : mesh.primitives) levels += primitive.size();
    return {{"levels", levels}};
}

json voxelStage(Bake& bake)
{
    bake.progress.begin("voxels", 1, "grids");
    bake.baked.voxels = voxelize(bake.baked.scene, /* staticOnly= */ true);
    bake.progress.advance(1);
    bake.progress.end();
    return json::object(); // what it is, the folder's writer says
}
}
