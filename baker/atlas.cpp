#include "baker/atlas.hpp"
#include "baker/atlas_report.hpp"
#include "baker/atlas_rewrite.hpp"
#include "engine/core/error.hpp"
#include <algorithm>
#include <cmath>

namespace afterglow
{
namespace
{
constexpr double kMostPages = 64; // of the largest size: from there every density gives way
constexpr double kPacked = 0.6;   // of a page's area, expected to be charts, when pages are counted ahead
constexpr int kGrain = 8;         // texels: the lightmap's tile

double area(const Scene& scene, const Object& object) // m2
{
    Surface surface = surfaceOf(scene, scene.meshes[object.mesh], dmat3(object.toWorld));
    double sum = 0.0;
    for (double a : surface.areas) sum += a;
    return sum;
}

// Texels per metre of world, per object: its own or the bake's; all of them lower when the level would fill too many pages.
std::vector<double> affordableDensities(Scene& scene, const AtlasOptions& options)
{
    std::vector<double> densities;
    double texels = 0.0;
    for (const Object& object : scene.objects) {
        densities.push_back(double(object.texelsPerMetre > 0.0f ? object.texelsPerMetre : options.texelsPerMetre));
        if (object.isStatic) texels += area(scene, object) * densities.back() * densities.back();
    }
    double most = kMostPages * kPacked * options.maxPageSize * options.maxPageSize;
    if (texels <= most) return densities;
    double factor = std::sqrt(most / texels);
    for (double& density : densities) density *= factor;
    scene.warnings.push_back("the level asks for more than " + std::to_string(int(kMostPages)) + " lightmap pages of " +
                             std::to_string(options.maxPageSize) + " texels: every density is lowered to " +
                             std::to_string(100.0 * factor) + " % of what was asked");
    return densities;
}
}

Atlas makeAtlas(Scene& scene, const AtlasOptions& options, const Advance& advance)
{
    check(options.texelsPerMetre > 0.0f && options.pageSize >= kGrain && options.maxPageSize >= kGrain, "atlas options are positive");
    const int largest = options.maxPageSize / kGrain * kGrain;
    const PageLimits limits{min(options.pageSize / kGrain * kGrain, largest), largest, kGrain};
    std::vector<UnwrappedMesh> meshes = unwrapMeshes(scene, affordableDensities(scene, options), options, limits, advance);

    // What each object asks of a page: its charts, or the one rectangle of its shared mesh.
    std::vector<Footprints> wanted(scene.objects.size());
    int charts = 0;
    for (const UnwrappedMesh& mesh : meshes) {
        charts += int(mesh.charts.size() * mesh.objects.size());
        for (std::size_t user = 0; user < mesh.objects.size(); ++user) {
            Footprints& footprints = wanted[mesh.objects[user]];
            if (mesh.shared())
                footprints.push_back(&mesh.rectangles[user]);
            else
                for (const FlatChart& chart : mesh.charts) footprints.push_back(&chart.footprint);
        }
    }
    Pages pages = sharePages(wanted, limits);

    Atlas atlas;
    atlas.pageSizes = pages.sizes;
    atlas.places.resize(scene.objects.size());
    for (std::size_t o = 0; o < scene.objects.size(); ++o) atlas.places[o].page = pages.page[o];
    std::vector<ChartPlaces> chartPlaces;
    for (const UnwrappedMesh& mesh : meshes) {
        if (!mesh.shared()) {
            std::size_t object = mesh.objects[0];
            chartPlaces.push_back({pages.origins[object], pages.sizes[std::size_t(pages.page[object])]});
            continue;
        }
        chartPlaces.push_back({mesh.own.origins, mesh.own.size});
        for (std::size_t user = 0; user < mesh.objects.size(); ++user) {
            std::size_t object = mesh.objects[user];
            vec2 size(pages.sizes[std::size_t(pages.page[object])]);
            atlas.places[object].scale = vec2(dvec2(mesh.own.size) * mesh.scales[user]) / size;
            atlas.places[object].offset = vec2(pages.origins[object][0]) / size;
        }
    }
    rewriteMeshes(scene, meshes, chartPlaces);
    atlas.report = measureAtlas(scene, atlas.places, atlas.pageSizes, charts);
    return atlas;
}
}
