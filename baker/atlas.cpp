#include <fmt/format.h> // first: it has a member called `check`, as error.hpp has a macro

#include "baker/atlas.hpp"
#include "baker/atlas_fill.hpp"
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
constexpr double kFilled = 0.75;  // the same of pages to be filled: where the search for their density begins
constexpr int kGrain = 8;         // texels: the lightmap's tile

double area(const Scene& scene, const Object& object) // m2
{
    Surface surface = surfaceOf(scene, scene.meshes[object.mesh], dmat3(object.toWorld));
    double sum = 0.0;
    for (double a : surface.areas) sum += a;
    return sum;
}

// Texels per metre of world, per object: its own or the bake's; all of them lower when the level would fill too many pages, and about
// those that fill them when they are counted.
std::vector<double> densitiesOf(Scene& scene, const AtlasOptions& options)
{
    std::vector<double> densities;
    double texels = 0.0;
    for (const Object& object : scene.objects) {
        densities.push_back(double(object.texelsPerMetre > 0.0f ? object.texelsPerMetre : options.texelsPerMetre));
        if (object.isStatic) texels += area(scene, object) * densities.back() * densities.back();
    }
    const bool fills = options.pages > 0;
    double most = fills ? kFilled * options.pages * options.pageSize * options.pageSize
                        : kMostPages * kPacked * options.maxPageSize * options.maxPageSize;
    if (!(texels > most) && !(fills && texels > 0.0)) return densities;
    double factor = std::sqrt(most / texels);
    for (double& density : densities) density *= factor;
    if (fills) return densities;
    scene.warnings.push_back(
        fmt::format("the level asks for more than {} lightmap pages of {} texels: every density is lowered to {:.3g} % of what was asked",
                    int(kMostPages), options.maxPageSize, 100.0 * factor));
    return densities;
}

}

Atlas makeAtlas(Scene& scene, const AtlasOptions& options, const Advance& advance)
{
    check(options.texelsPerMetre > 0.0f && options.pageSize >= kGrain && options.maxPageSize >= kGrain, "atlas options are positive");
    const int largest = options.maxPageSize / kGrain * kGrain, edge = min(options.pageSize / kGrain * kGrain, largest);
    const PageLimits limits{edge, options.pages > 0 ? edge : largest, kGrain};
    std::vector<UnwrappedMesh> meshes = unwrapMeshes(scene, densitiesOf(scene, options), options.pieces, limits, advance);
    if (options.pages == 0) setOnTexels(meshes, scene, options.padding, limits);
    const Pages pages = options.pages > 0 ? fill(meshes, scene.objects.size(), options.padding, options.pages, limits)
                                          : sharePages(wantedBy(meshes, scene.objects.size()), limits);

    Atlas atlas;
    atlas.pageSizes = pages.sizes;
    atlas.places.resize(scene.objects.size());
    for (std::size_t o = 0; o < pages.page.size(); ++o) atlas.places[o].page = pages.page[o];
    int charts = 0;
    std::vector<ChartPlaces> chartPlaces;
    for (const UnwrappedMesh& mesh : meshes) {
        charts += int(mesh.charts.size() * mesh.objects.size());
        if (!mesh.shared()) {
            std::size_t object = mesh.objects[0];
            chartPlaces.push_back({pages.spots[object], pages.sizes[std::size_t(pages.page[object])]});
            continue;
        }
        chartPlaces.push_back({mesh.own.spots, mesh.own.size});
        for (std::size_t user = 0; user < mesh.objects.size(); ++user) {
            std::size_t object = mesh.objects[user];
            vec2 size(pages.sizes[std::size_t(pages.page[object])]);
            atlas.places[object].scale = vec2(dvec2(mesh.own.size) * mesh.scales[user]) / size;
            atlas.places[object].offset = vec2(pages.spots[object][0].origin) / size;
        }
    }
    rewriteMeshes(scene, meshes, chartPlaces);
    atlas.report = measureAtlas(scene, atlas.places, atlas.pageSizes, charts);
    return atlas;
}
}
