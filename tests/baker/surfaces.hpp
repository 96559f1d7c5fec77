// Surfaces as triangles in double precision, and what is true of them as a whole.
#pragma once
#include "baker/distance.hpp"
#include "tests/baker/shapes.hpp"
#include <map>

namespace afterglow
{
inline std::vector<Corners> corners(const Scene& scene, const std::vector<uint>& indices)
{
    std::vector<Corners> result;
    for (std::size_t i = 0; i < indices.size(); i += 3)
        result.push_back({dvec3(scene.vertices[indices[i]].position), dvec3(scene.vertices[indices[i + 1]].position),
                          dvec3(scene.vertices[indices[i + 2]].position)});
    return result;
}

inline double area(const std::vector<Corners>& surface)
{
    double sum = 0;
    for (const Corners& t : surface) sum += length(cross(t[1] - t[0], t[2] - t[0])) / 2;
    return sum;
}

inline dvec3 unitNormal(const Corners& t) { return normalize(cross(t[1] - t[0], t[2] - t[0])); }

// Edges of positions that are not met once in each direction: 0 for a closed surface.
inline int openEdges(const std::vector<Corners>& surface)
{
    std::map<std::array<double, 6>, int> balance;
    for (const Corners& t : surface)
        for (std::size_t i = 0; i < 3; ++i) {
            const dvec3 &a = t[i], &b = t[(i + 1) % 3];
            ++balance[{a.x, a.y, a.z, b.x, b.y, b.z}];
            --balance[{b.x, b.y, b.z, a.x, a.y, a.z}];
        }
    int open = 0;
    for (const auto& [edge, count] : balance) open += count > 0;
    return open;
}
}
