#include "baker/atlas_rewrite.hpp"
#include <algorithm>
#include <tuple>

namespace afterglow
{
namespace
{
struct Geometry {
    std::vector<Vertex> vertices;
    std::vector<uint> indices;
};

Primitive copied(const Scene& scene, const Primitive& p, Geometry& out)
{
    Primitive copy{uint(out.vertices.size()), p.vertexCount, uint(out.indices.size()), p.indexCount, p.material};
    auto vertex = scene.vertices.begin() + p.firstVertex;
    auto index = scene.indices.begin() + p.firstIndex;
    out.vertices.insert(out.vertices.end(), vertex, vertex + p.vertexCount);
    out.indices.insert(out.indices.end(), index, index + p.indexCount);
    return copy;
}

struct MeshUv { // per corner of the mesh
    std::vector<uint> chart;
    std::vector<vec2> uv;
};

dvec2 placed(dvec2 corner, ivec2 size, const Spot& spot) // texels of the page
{
    for (int turn = 0; turn < spot.turns; ++turn) {
        corner = dvec2(size.y - corner.y, corner.x);
        std::swap(size.x, size.y);
    }
    return dvec2(spot.origin) + corner;
}

MeshUv uvOf(const UnwrappedMesh& mesh, const ChartPlaces& places)
{
    MeshUv result{std::vector<uint>(mesh.surface.indices.size()), std::vector<vec2>(mesh.surface.indices.size())};
    for (uint c = 0; c < mesh.charts.size(); ++c)
        for (std::size_t i = 0; i < mesh.charts[c].corners.size(); ++i) {
            std::size_t corner = 3 * mesh.charts[c].triangles[i / 3] + i % 3;
            result.chart[corner] = c;
            result.uv[corner] =
                vec2(placed(mesh.charts[c].corners[i], mesh.charts[c].footprint.size, places.spots[c]) / dvec2(places.size));
        }
    return result;
}

// `corner` is the primitive's first in the mesh, and moves on to the next primitive's.
Primitive split(const Scene& scene, const Primitive& p, const MeshUv& uv, uint& corner, Geometry& out)
{
    struct Use {
        uint vertex, chart; // the primitive's index i names this vertex in this chart, and a chart may be cut open at it
        vec2 uv;
        uint i;
    };
    std::vector<Use> uses;
    const uint count = p.indexCount / 3 * 3, first = corner;
    for (uint i = 0; i < count; ++i) uses.push_back({scene.indices[p.firstIndex + i], uv.chart[first + i], uv.uv[first + i], i});
    corner += count;
    std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) {
        return std::tie(a.vertex, a.chart, a.uv.x, a.uv.y, a.i) < std::tie(b.vertex, b.chart, b.uv.x, b.uv.y, b.i);
    });

    Primitive result{uint(out.vertices.size()), 0, uint(out.indices.size()), count, p.material};
    out.indices.resize(out.indices.size() + count);
    for (std::size_t u = 0; u < uses.size(); ++u) {
        if (u == 0 || uses[u].vertex != uses[u - 1].vertex || uses[u].chart != uses[u - 1].chart || uses[u].uv != uses[u - 1].uv) {
            out.vertices.push_back(scene.vertices[p.firstVertex + uses[u].vertex]);
            out.vertices.back().uv1 = uses[u].uv;
            ++result.vertexCount;
        }
        out.indices[result.firstIndex + uses[u].i] = result.vertexCount - 1;
    }
    return result;
}
}

void rewriteMeshes(Scene& scene, const std::vector<UnwrappedMesh>& meshes, const std::vector<ChartPlaces>& places)
{
    Geometry out;
    auto unwrapped = meshes.begin();
    for (uint m = 0; m < scene.meshes.size(); ++m) {
        std::vector<Primitive>& primitives = scene.meshes[m].primitives;
        if (unwrapped == meshes.end() || unwrapped->mesh != m) {
            for (Primitive& p : primitives) p = copied(scene, p, out);
            continue;
        }
        MeshUv uv = uvOf(*unwrapped, places[std::size_t(unwrapped - meshes.begin())]);
        uint corner = 0;
        for (Primitive& p : primitives) p = split(scene, p, uv, corner, out);
        ++unwrapped;
    }
    scene.vertices = std::move(out.vertices);
    scene.indices = std::move(out.indices);
}
}
