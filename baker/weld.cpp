#include "baker/weld.hpp"
#include "baker/sets.hpp"
#include "shaders/random.h"
#include <algorithm>
#include <bit>
#include <numeric>
#include <tuple>

namespace afterglow
{
namespace
{
constexpr double kSmooth = 0.5;        // 1 - cosine: where many sheets meet, those that turn by less than 60 degrees may be one
constexpr double kFolded = -0.9999;    // cosine: two faces of an edge that are each other's back
constexpr std::size_t kMostSides = 64; // at one edge: beyond, nothing there is paired

constexpr uint kNoVertex = ~0u;

struct Side {        // one side of a triangle
    uint low, high;  // points, ordered
    uint corner;     // where it starts; it ends at the triangle's next corner
    bool descending; // it runs from high to low
};

// Ids from 0 in the order in which positions come, by a table of the first vertex at each.
std::vector<uint> pointIds(std::span<const vec3> positions, uint& count)
{
    const std::size_t size = std::bit_ceil(2 * positions.size() + 1);
    std::vector<uint> table(size, kNoVertex), ids(positions.size());
    count = 0;
    for (uint v = 0; v < positions.size(); ++v) {
        const vec3 p = positions[v] + 0.0f; // -0 is 0
        std::size_t place = hash3(std::bit_cast<uint>(p.x), std::bit_cast<uint>(p.y), std::bit_cast<uint>(p.z)) & (size - 1);
        while (table[place] != kNoVertex && positions[table[place]] != p) place = (place + 1) & (size - 1);
        ids[v] = table[place] == kNoVertex ? count++ : ids[table[place]];
        if (table[place] == kNoVertex) table[place] = v;
    }
    return ids;
}

// By their ends, then by their corners. There are few at each low end: they are dealt out by it first.
void sortSides(std::vector<Side>& sides, uint points)
{
    std::vector<std::size_t> next(points + std::size_t(1));
    for (const Side& side : sides) ++next[side.low + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<Side> dealt(sides.size());
    for (const Side& side : sides) dealt[next[side.low]++] = side;
    for (std::size_t low = 0, begin = 0; low < points; begin = next[low++])
        std::sort(dealt.begin() + std::ptrdiff_t(begin), dealt.begin() + std::ptrdiff_t(next[low]),
                  [](const Side& a, const Side& b) { return std::tie(a.high, a.corner) < std::tie(b.high, b.corner); });
    sides = std::move(dealt);
}

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
    sortSides(sides, result.points);

    // Corners become one vertex only across sides that are paired. What is reached by turning about a point over paired sides is one fan,
    // and a fan is what a half-edge mesh can hold.
    Sets sets(indices.size());
    result.across.assign(indices.size(), kNoCorner);
    for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
        for (end = i; end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high;) ++end;
        std::span<const Side> edge(&sides[i], end - i);
        std::size_t paired = 0;
        for (auto [a, b] : pairs(edge, positions, indices)) {
            sets.join(a, nextCorner(b));
            sets.join(nextCorner(a), b);
            result.across[a] = b, result.across[b] = a;
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
