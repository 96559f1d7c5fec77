#include "engine/upload/edges.hpp"
#include "engine/scene/places.hpp"
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace afterglow
{
namespace
{
// A face as one of its edges sees it; from < to.
struct Side {
    uint from, to, third, material;
};

std::vector<Side> sidesOf(const Scene& scene, const Mesh& mesh)
{
    uint lower = std::numeric_limits<uint>::max(), upper = 0;
    for (const Primitive& primitive : mesh.primitives) {
        lower = std::min(lower, primitive.firstVertex);
        upper = std::max(upper, primitive.firstVertex + primitive.vertexCount);
    }
    if (lower >= upper) return {};
    const std::vector<uint> first = firstOfPlace(std::span(scene.vertices).subspan(lower, upper - lower));
    std::vector<Side> sides;
    for (const Primitive& primitive : mesh.primitives) {
        if (scene.materials[primitive.material].flags & kMaterialAlphaMask) continue;
        for (uint i = 0; i + 2 < primitive.indexCount; i += 3) {
            uint corner[3];
            for (uint k = 0; k < 3; ++k)
                corner[k] = lower + first[primitive.firstVertex + scene.indices[primitive.firstIndex + i + k] - lower];
            for (uint k = 0; k < 3; ++k) {
                const uint a = corner[k], b = corner[(k + 1) % 3];
                if (a != b) sides.push_back({std::min(a, b), std::max(a, b), corner[(k + 2) % 3], primitive.material});
            }
        }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
        return std::tie(a.from, a.to, a.third, a.material) < std::tie(b.from, b.to, b.third, b.material);
    });
    return sides;
}

// Where more than two faces meet, those that lie on each other (a sheet with two sides) are no crease, and the flattest pair is the one
// whose silhouette counts.
MeshEdge edgeOf(const Scene& scene, const Side* sides, std::size_t count, float creaseCosine)
{
    MeshEdge edge{sides[0].from, sides[0].to, sides[0].third, sides[0].third, 0u};
    if (count == 1) {
        edge.kinds = kEdgeBorder;
        return edge;
    }
    constexpr float kFolded = 0.99999f; // a quarter of a degree
    edge.kinds = kEdgeSilhouette;
    float flattest = 2.0f;
    const auto at = [&](uint vertex) { return scene.vertices[vertex].position; };
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 1; j < count; ++j) {
            const float cosine = facesCosine(at(edge.from), at(edge.to), at(sides[i].third), at(sides[j].third));
            if (isCrease(cosine, creaseCosine) && (count == 2 || cosine < kFolded)) edge.kinds |= kEdgeCrease;
            if (sides[i].material != sides[j].material) edge.kinds |= kEdgeMaterial;
            if (!(cosine < flattest)) continue;
            flattest = cosine;
            edge.left = sides[i].third;
            edge.right = sides[j].third;
        }
    return edge;
}
}

std::vector<MeshEdge> meshEdges(const Scene& scene, const Mesh& mesh, float creaseAngle)
{
    const std::vector<Side> sides = sidesOf(scene, mesh);
    std::vector<MeshEdge> edges;
    for (std::size_t i = 0, next = 0; i < sides.size(); i = next) {
        for (next = i; next < sides.size() && sides[next].from == sides[i].from && sides[next].to == sides[i].to;) ++next;
        edges.push_back(edgeOf(scene, &sides[i], next - i, std::cos(creaseAngle)));
    }
    return edges;
}

GpuEdges uploadEdges(Gpu& gpu, const Scene& scene, const std::vector<DrawItem>& items, float creaseAngle)
{
    GpuEdges result;
    std::vector<MeshEdge> all;
    std::vector<std::pair<uint, uint>> ranges; // by mesh: first, count
    for (const Mesh& mesh : scene.meshes) {
        const std::vector<MeshEdge> edges = meshEdges(scene, mesh, creaseAngle);
        ranges.emplace_back(uint(all.size()), uint(edges.size()));
        all.insert(all.end(), edges.begin(), edges.end());
    }
    if (all.empty()) return result;
    result.edges = gpu.memory.buffer("edges", all.size() * sizeof(MeshEdge), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    gpu.memory.upload(result.edges, all.data(), all.size() * sizeof(MeshEdge));
    for (std::size_t i = 0, next = 0; i < items.size(); i = next) {
        const uint object = items[i].instance.object;
        for (next = i; next < items.size() && items[next].instance.object == object;) ++next;
        const auto [first, count] = ranges[scene.objects[object].mesh];
        if (count > 0) result.draws.push_back({first, count, i, next - i});
    }
    return result;
}
}
