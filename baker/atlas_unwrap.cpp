#include <fmt/format.h> // first: it has a member called `check`, as error.hpp has a macro

#include "baker/atlas_unroll.hpp"
#include "baker/atlas_unwrap.hpp"
#include "engine/core/error.hpp"
#include <algorithm>
#include <cmath>

namespace afterglow
{
namespace
{
constexpr double kRounding = 1.0 / 256; // texels: what float uv and scales may move a corner on a large page, and more
constexpr double kLongest = 0.61;      // of a page's edge: charts that are joined get no longer; at 0.5 a ball alone on its page is 8 to 10
constexpr double kSameScale = 0.02;    // objects of one mesh whose densities agree so well share its size in texels
constexpr double kDensityStep = 0.85;  // of an object that does not fit the largest page, until it does
constexpr double kLeastDensity = 1e-6; // of what was asked: an object that fits no page even then never will

double linearScale(const Object& object) { return std::cbrt(std::abs(determinant(dmat3(object.toWorld)))); }

Footprint rectangle(ivec2 size) { return {size, {{ivec2(0), size}}, /* turns= */ false}; }

Footprints footprints(const std::vector<FlatChart>& charts)
{
    Footprints result;
    for (const FlatChart& chart : charts) result.push_back(&chart.footprint);
    return result;
}

// A shared mesh is packed once into a rectangle; its users get rectangles of that size, or larger.
bool packRectangles(UnwrappedMesh& mesh, const PageLimits& limits)
{
    std::optional<Packing> own = pack(footprints(mesh.charts), limits.largestEdge, 1);
    if (!own) return false;
    mesh.own = std::move(*own);
    mesh.rectangles.clear();
    for (double scale : mesh.scales) mesh.rectangles.push_back(rectangle(ivec2(ceil(dvec2(mesh.own.size) * scale))));
    return std::all_of(mesh.rectangles.begin(), mesh.rectangles.end(),
                       [&](const Footprint& f) { return max(f.size.x, f.size.y) <= limits.largestEdge; });
}

void cut(UnwrappedMesh& mesh, Scene& scene, const std::vector<double>& densities, const Pieces& pieces, const PageLimits& limits,
         const Advance& joined)
{
    // Per user, texels per metre of object space; the coarsest decides, so that padding suffices for all.
    std::vector<double>& scales = mesh.scales;
    for (std::size_t o : mesh.objects) scales.push_back(densities[o] * linearScale(scene.objects[o]));
    std::size_t coarsest = std::size_t(std::min_element(scales.begin(), scales.end()) - scales.begin());
    double least = scales[coarsest];
    for (double& scale : scales) scale = scale > least * (1.0 + kSameScale) && least > 0.0 ? scale / least : 1.0;
    std::swap(mesh.objects[0], mesh.objects[coarsest]), std::swap(scales[0], scales[coarsest]);

    mesh.asked = densities[mesh.objects[0]];
    mesh.surface = surfaceOf(scene, scene.meshes[mesh.mesh], dmat3(scene.objects[mesh.objects[0]].toWorld));
    if (mesh.mesh < pieces.size() && !pieces[mesh.mesh].empty()) mesh.surface.pieces = pieces[mesh.mesh];
    const double texel = 1.0 / mesh.asked; // m
    Charts charts = growCharts(mesh.surface, texel, joined);
    if (charts.partedEdges > 0)
        scene.warnings.push_back("mesh '" + scene.meshes[mesh.mesh].name + "' has " + std::to_string(charts.partedEdges) +
                                 " edges where three or more faces meet, or two of opposite winding: its lightmap charts end there");
    mesh.charts = unroll(mesh.surface, charts.across, flatten(mesh.surface, charts, texel), {texel, kLongest * limits.edge * texel});
}
}

bool setOnTexels(UnwrappedMesh& mesh, double factor, int padding, const PageLimits& limits)
{
    // A larger copy is not aligned with the texels it was laid out on: half a texel more keeps its charts as far apart.
    const bool aligned = std::all_of(mesh.scales.begin(), mesh.scales.end(), [](double scale) { return scale == 1.0; });
    const double margin = max(1.0, padding / 2.0) + (aligned ? 0.0 : 0.5) + kRounding;
    return setOnTexels(mesh.charts, {mesh.asked * factor, margin, double(limits.largestEdge)}) &&
           (!mesh.shared() || packRectangles(mesh, limits));
}

void setOnTexels(std::vector<UnwrappedMesh>& meshes, Scene& scene, int padding, const PageLimits& limits)
{
    for (UnwrappedMesh& mesh : meshes) {
        double factor = 1.0;
        while (!setOnTexels(mesh, factor, padding, limits) || !(mesh.shared() || fitsPage(footprints(mesh.charts), limits))) {
            factor *= kDensityStep;
            if (factor < kLeastDensity)
                throw Error("mesh '" + scene.meshes[mesh.mesh].name + "' falls into " + std::to_string(mesh.charts.size()) +
                            " separate pieces, too many for a lightmap page: join them, or give its objects ag_static = false");
        }
        if (factor < 1.0)
            scene.warnings.push_back(
                fmt::format("object '{}' is too large for a lightmap page of {} texels at {:.4g} texels per metre: it gets {:.4g}",
                            scene.objects[mesh.objects[0]].name, limits.largestEdge, mesh.asked, mesh.asked * factor));
    }
}

std::vector<UnwrappedMesh> unwrapMeshes(Scene& scene, const std::vector<double>& densities, const Pieces& pieces, const PageLimits& limits,
                                        const Advance& advance)
{
    std::vector<std::vector<std::size_t>> users(scene.meshes.size());
    for (std::size_t o = 0; o < scene.objects.size(); ++o)
        if (scene.objects[o].isStatic) users[scene.objects[o].mesh].push_back(o);

    std::vector<UnwrappedMesh> meshes;
    for (uint m = 0; m < scene.meshes.size(); ++m) {
        std::uint64_t left = 0; // triangles
        for (const Primitive& primitive : scene.meshes[m].primitives) left += primitive.indexCount / 3;
        if (left > 0 && !users[m].empty()) {
            UnwrappedMesh& mesh = meshes.emplace_back();
            mesh.mesh = m;
            mesh.objects = users[m];
            cut(mesh, scene, densities, pieces, limits, [&](std::uint64_t joined) {
                left -= joined;
                advance(joined);
            });
        }
        advance(left);
    }
    return meshes;
}
}
