#include "baker/weld.hpp"
#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

namespace afterglow
{
namespace
{
struct Side {        // one side of a triangle
    uint low, high;  // points, ordered
    uint corner;     // where it starts; it ends at the triangle's next corner
    bool descending; // it runs from high to low
};

std::vector<uint> pointIds(std::span<const vec3> positions, uint& count)
{
    auto key = [&](uint v) { return std::array{positions[v].x + 0.0f, positions[v].y + 0.0f, positions[v].z + 0.0f}; };
    std::vector<uint> order(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](uint a, uint b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });

    std::vector<uint> ids(positions.size());
    count = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i > 0 && key(order[i]) != key(order[i - 1])) ++count;
        ids[order[i]] = count;
    }
    count += positions.empty() ? 0 : 1;
    return ids;
}

uint root(std::vector<uint>& parent, uint i)
{
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}

uint nextCorner(uint corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
}

Weld weld(std::span<const vec3> positions, std::span<const uint> indices)
{
    Weld result;
    result.point = pointIds(positions, result.points);

    std::vector<Side> sides;
    sides.reserve(indices.size());
    for (uint corner = 0; corner < indices.size(); ++corner) {
        uint from = result.point[indices[corner]], to = result.point[indices[nextCorner(corner)]];
        if (from != to) sides.push_back({min(from, to), max(from, to), corner, from > to});
    }
    std::sort(sides.begin(), sides.end(),
              [](const Side& a, const Side& b) { return std::tie(a.low, a.high, a.corner) < std::tie(b.low, b.high, b.corner); });

    // Corners become one vertex only across edges that a manifold allows: two faces, opposite directions. What is reached by
    // turning about a point over such edges is one fan, and a fan is what a half-edge mesh can hold.
    std::vector<uint> parent(indices.size());
    std::iota(parent.begin(), parent.end(), 0u);
    auto join = [&](uint a, uint b) {
        a = root(parent, a), b = root(parent, b);
        parent[max(a, b)] = min(a, b);
    };
    for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
        for (end = i; end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high;) ++end;
        if (end - i == 2 && sides[i].descending != sides[i + 1].descending) {
            join(sides[i].corner, nextCorner(sides[i + 1].corner));
            join(nextCorner(sides[i].corner), sides[i + 1].corner);
        } else if (end - i > 1)
            ++result.partedEdges;
    }

    result.vertex.resize(indices.size());
    for (uint corner = 0; corner < indices.size(); ++corner) {
        uint first = root(parent, corner);
        if (first == corner) {
            result.vertex[corner] = uint(result.pointOfVertex.size());
            result.pointOfVertex.push_back(result.point[indices[corner]]);
        } else
            result.vertex[corner] = result.vertex[first];
    }
    return result;
}
}
