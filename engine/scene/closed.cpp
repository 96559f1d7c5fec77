#include "engine/scene/closed.hpp"
#include "engine/scene/places.hpp"
#include <algorithm>
#include <map>
#include <span>

namespace afterglow
{
namespace
{
// Which part of the body each vertex belongs to: a forest whose roots stand for the parts.
uint rootOf(std::vector<uint>& parent, uint v)
{
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
}
}

bool isClosedBody(const Scene& scene, const Primitive& primitive)
{
    const std::span vertices(scene.vertices.data() + primitive.firstVertex, primitive.vertexCount);
    const std::vector<uint> first = firstOfPlace(vertices);
    std::vector<uint> parent = first;
    std::vector<std::pair<std::uint64_t, int>> edges; // both ends, the lower first; +1 run through that way, -1 the other
    for (uint i = 0; i + 2 < primitive.indexCount; i += 3)
        for (uint k = 0; k < 3; ++k) {
            const uint a = first[scene.indices[primitive.firstIndex + i + k]],
                       b = first[scene.indices[primitive.firstIndex + i + (k + 1) % 3]];
            if (a == b) continue;
            edges.emplace_back(std::uint64_t(std::min(a, b)) << 32 | std::max(a, b), a < b ? 1 : -1);
            parent[rootOf(parent, a)] = rootOf(parent, b);
        }
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0; i < edges.size();) {
        int balance = 0;
        const std::uint64_t edge = edges[i].first;
        for (; i < edges.size() && edges[i].first == edge; ++i) balance += edges[i].second;
        if (balance != 0) return false;
    }

    std::map<uint, double> volumes; // six times each part's, counted from one of its own corners
    for (uint i = 0; i + 2 < primitive.indexCount; i += 3) {
        const uint* corner = &scene.indices[primitive.firstIndex + i];
        const uint part = rootOf(parent, first[corner[0]]);
        const dvec3 from(vertices[part].position);
        const dvec3 a = dvec3(vertices[corner[0]].position) - from, b = dvec3(vertices[corner[1]].position) - from;
        volumes[part] += dot(a, cross(b, dvec3(vertices[corner[2]].position) - from));
    }
    return !volumes.empty() && std::all_of(volumes.begin(), volumes.end(), [](const auto& part) { return part.second > 0.0; });
}
}
