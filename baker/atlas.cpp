#include <fmt/format.h> // first: it has a member called `check`, as error.hpp has a macro

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
constexpr double kFilled = 0.75;  // the same of pages to be filled: where the search for their density begins
constexpr int kTrials = 6;        // of that search
constexpr int kMostTrials = 40;   // while nothing has fitted
constexpr double kSolved = 0.001; // of a density: two that are nearer are not told apart
constexpr double kTooLarge = 2.0; // times a page: a chart that no page holds
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

// What each object asks of a page: its charts, or the one rectangle of its shared mesh.
std::vector<Footprints> wantedBy(const std::vector<UnwrappedMesh>& meshes, std::size_t objects)
{
    std::vector<Footprints> wanted(objects);
    for (const UnwrappedMesh& mesh : meshes)
        for (std::size_t user = 0; user < mesh.objects.size(); ++user) {
            Footprints& footprints = wanted[mesh.objects[user]];
            if (mesh.shared())
                footprints.push_back(&mesh.rectangles[user]);
            else
                for (const FlatChart& chart : mesh.charts) footprints.push_back(&chart.footprint);
        }
    return wanted;
}

// Of its pages, how much a layout uses: above 1 it does not fit.
double usedOf(const Pages& pages, int count, int edge)
{
    double rows = 0.0, highest = 0.0;
    for (const ivec2& size : pages.sizes) rows += size.y, highest = max(highest, double(size.y));
    return max(rows / (double(count) * edge), highest > edge ? highest / edge : 0.0);
}

// At the largest factor on all densities that was found at which `count` pages suffice. What is used grows as the factor's square, but for
// the whims of packing: from every trial follows the next one.
Pages fill(std::vector<UnwrappedMesh>& meshes, std::size_t objects, int padding, int count, const PageLimits& limits)
{
    double fits = 0.0, spills = 0.0, factor = 1.0;
    int spilled = 0; // trials in a row
    Pages best;
    for (int trial = 0; trial < kMostTrials && (fits == 0.0 || trial < kTrials); ++trial) {
        bool flat = true;
        for (UnwrappedMesh& mesh : meshes) flat = flat && setOnTexels(mesh, factor, padding, limits);
        const Pages pages = flat ? fillPages(wantedBy(meshes, objects), count, limits) : Pages{};
        const double used = flat ? usedOf(pages, count, limits.edge) : kTooLarge;
        if (used <= 1.0)
            fits = factor, best = pages, spilled = 0;
        else
            spills = factor, ++spilled;
        double next = factor / std::sqrt(used);
        const bool known = next < fits * (1 + kSolved) || next > spills * (1 - kSolved);
        if (fits > 0.0 && spills > 0.0 && (known || spilled > 1)) next = 0.5 * (fits + spills);
        if (fits == 0.0) next = min(next, spills * (1 - kSolved));
        if (fits > 0.0 && next < fits * (1 + kSolved)) break;
        factor = next;
    }
    if (fits == 0.0) throw Error("the level falls into too many pieces for its lightmap pages: ask for more or larger ones");
    for (UnwrappedMesh& mesh : meshes) setOnTexels(mesh, fits, padding, limits);
    for (ivec2& size : best.sizes) size = ivec2(limits.edge);
    return best;
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
