#include "baker/weld.hpp"
#include "baker/sets.hpp"
#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

namespace afterglow
{
namespace
{
constexpr double kSmooth = 0.5;        // 1 - cosine: where many sheets meet, those that turn by less than 60 degrees may be one
constexpr double kFolded = -0.9999;    // cosine: two faces of an edge that are each other's back
constexpr std::size_t kMostSides = 64; // at one edge: beyond, nothing there is paired

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

uint nextCorner(uint corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

dvec3 normal(std::span<const vec3> positions, std::span<const uint> indices, uint corner)
{
    const uint* t = &indices[corner / 3 * 3];
    dvec3 a(positions[t[0]]), n = cross(dvec3(positions[t[1]]) - a, dvec3(positions[t[2]]) - a);
    return dot(n, n) > 0.0 ? normalize(n) : n;
}

// Front and back of a card without thickness: two sheets, or its border could creep inwards unseen by any distance to planes.
bool backToBack(std::span<const Side> edge, std::span<const vec3> positions, std::span<const uint> indices)
{
    return dot(normal(positions, indices, edge[0].corner), normal(positions, indices, edge[1].corner)) < kFolded;
}

// Which sides at one edge belong together, by the corners where they start. Two that run in opposite directions do. Of more, those that
// share vertices come first, then those that continue each other most smoothly: a floor runs on under the wall that stands on it.
std::vector<std::pair<uint, uint>> pairs(std::span<const Side> edge, std::span<const vec3> positions, std::span<const uint> indices)
{
    if (edge.size() == 2 && edge[0].descending != edge[1].descending && !backToBack(edge, positions, indices))
        return {{edge[0].corner, edge[1].corner}};
    if (edge.size() <= 2 || edge.size() > kMostSides) return {};
    struct Pair {
        bool apart;  // their vertices differ
        double turn; // 1 - cosine
        uint a, b;
    };
    std::vector<Pair> all;
    for (std::size_t i = 0; i < edge.size(); ++i)
        for (std::size_t j = i + 1; j < edge.size(); ++j) {
            uint a = edge[i].corner, b = edge[j].corner;
            double turn = 1.0 - dot(normal(positions, indices, a), normal(positions, indices, b));
            bool together = indices[a] == indices[nextCorner(b)] && indices[nextCorner(a)] == indices[b];
            if (edge[i].descending != edge[j].descending && turn < kSmooth) all.push_back({!together, turn, a, b});
        }
    std::sort(all.begin(), all.end(),
              [](const Pair& p, const Pair& q) { return std::tie(p.apart, p.turn, p.a, p.b) < std::tie(q.apart, q.turn, q.a, q.b); });
    std::vector<std::pair<uint, uint>> result;
    std::vector<uint> taken;
    auto isFree = [&](uint corner) { return std::find(taken.begin(), taken.end(), corner) == taken.end(); };
    for (const Pair& pair : all)
        if (isFree(pair.a) && isFree(pair.b)) {
            result.push_back({pair.a, pair.b});
            taken.insert(taken.end(), {pair.a, pair.b});
        }
    return result;
}
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

    // Corners become one vertex only across sides that are paired. What is reached by turning about a point over paired sides is one fan,
    // and a fan is what a half-edge mesh can hold.
    Sets sets(indices.size());
    for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
        for (end = i; end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high;) ++end;
        std::span<const Side> edge(&sides[i], end - i);
        std::size_t paired = 0;
        for (auto [a, b] : pairs(edge, positions, indices)) {
            sets.join(a, nextCorner(b));
            sets.join(nextCorner(a), b);
            paired += 2;
        }
        if (edge.size() > 1 && paired < edge.size()) ++result.partedEdges;
    }

    result.vertex.resize(indices.size());
    for (uint corner = 0; corner < indices.size(); ++corner) {
        uint first = sets.root(corner);
        if (first == corner) {
            result.vertex[corner] = uint(result.pointOfVertex.size());
            result.pointOfVertex.push_back(result.point[indices[corner]]);
        } else
            result.vertex[corner] = result.vertex[first];
    }
    return result;
}
}
