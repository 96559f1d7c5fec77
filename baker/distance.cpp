#include "baker/distance.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace afterglow
{
namespace
{
constexpr uint kLeaf = 4;          // triangles
constexpr int kFinestLattice = 16; // samples along a triangle's side

// The point of the triangle nearest to p (Ericson, Real-Time Collision Detection, 5.1.5).
dvec3 nearestOf(const Corners& t, const dvec3& p)
{
    dvec3 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0];
    double d1 = dot(ab, ap), d2 = dot(ac, ap);
    if (d1 <= 0 && d2 <= 0) return t[0];
    dvec3 bp = p - t[1];
    double d3 = dot(ab, bp), d4 = dot(ac, bp);
    if (d3 >= 0 && d4 <= d3) return t[1];
    double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return d1 > d3 ? t[0] + ab * (d1 / (d1 - d3)) : t[0];
    dvec3 cp = p - t[2];
    double d5 = dot(ab, cp), d6 = dot(ac, cp);
    if (d6 >= 0 && d5 <= d6) return t[2];
    double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return d2 > d6 ? t[0] + ac * (d2 / (d2 - d6)) : t[0];
    double va = d3 * d6 - d5 * d4, along = d4 - d3, back = d5 - d6;
    if (va <= 0 && along >= 0 && back >= 0) return along + back > 0 ? t[1] + (t[2] - t[1]) * (along / (along + back)) : t[1];
    return t[0] + (ab * vb + ac * vc) / (va + vb + vc);
}

double squared(const dvec3& v) { return dot(v, v); }

}

DistanceTree::DistanceTree(std::vector<Corners> triangles) : given_(std::move(triangles)), triangles_(given_.size())
{
    std::iota(triangles_.begin(), triangles_.end(), 0u);
    nodes_.reserve(triangles_.size() + 1);
    nodes_.push_back({.begin = 0, .end = uint(triangles_.size())});
    for (uint node = 0; node < nodes_.size(); ++node) build(node);
}

// Bounds the node's triangles and, when they are many, halves them along the longest side of their centres.
void DistanceTree::build(uint node)
{
    const uint begin = nodes_[node].begin, end = nodes_[node].end;
    Box box;
    dvec3 lowest(1e300), highest(-1e300);
    auto centre = [&](uint t) { return given_[t][0] + given_[t][1] + given_[t][2]; };
    for (uint i = begin; i < end; ++i) {
        for (const dvec3& p : given_[triangles_[i]]) box.add(p);
        lowest = min(lowest, centre(triangles_[i])), highest = max(highest, centre(triangles_[i]));
    }
    nodes_[node].box = box;
    if (end - begin <= kLeaf) return;

    dvec3 extent = highest - lowest;
    int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    uint middle = (begin + end) / 2;
    auto first = triangles_.begin();
    std::nth_element(first + begin, first + middle, first + end, [&](uint a, uint b) { return centre(a)[axis] < centre(b)[axis]; });
    nodes_[node].children = uint(nodes_.size());
    nodes_.push_back({.begin = begin, .end = middle});
    nodes_.push_back({.begin = middle, .end = end});
}

DistanceTree::Place DistanceTree::nearest(const dvec3& point) const
{
    Place found;
    double best = 1e300;
    struct Visit {
        uint node;
        double squared;
    };
    std::array<Visit, 64> stack;
    int size = 0;
    stack[std::size_t(size++)] = {0, 0.0};
    while (size > 0) {
        Visit visit = stack[std::size_t(--size)];
        if (visit.squared >= best) continue;
        const Node& node = nodes_[visit.node];
        if (node.children == 0) {
            for (uint i = node.begin; i < node.end; ++i) {
                const dvec3 there = nearestOf(given_[triangles_[i]], point);
                if (squared(point - there) < best) best = squared(point - there), found = {triangles_[i], there};
            }
            continue;
        }
        Visit near{node.children, squared(point - nodes_[node.children].box.nearest(point))};
        Visit far{node.children + 1, squared(point - nodes_[node.children + 1].box.nearest(point))};
        if (far.squared < near.squared) std::swap(near, far);
        stack[std::size_t(size++)] = far;
        stack[std::size_t(size++)] = near;
    }
    found.distance = std::sqrt(best);
    return found;
}

double DistanceTree::operator()(const dvec3& point) const { return given_.empty() ? 0.0 : nearest(point).distance; }

std::vector<dvec3> samples(const Corners& t, double spacing)
{
    std::vector<dvec3> weights;
    double longest = max(max(distance(t[0], t[1]), distance(t[1], t[2])), distance(t[2], t[0]));
    int n = spacing > 0.0 ? std::clamp(int(std::ceil(longest / spacing)), 1, kFinestLattice) : 1;
    for (int i = 0; i < n; ++i)
        for (int j = 0; i + j < n; ++j) {
            const double u = (i + 1.0 / 3) / n, v = (j + 1.0 / 3) / n;
            weights.push_back({1 - u - v, u, v});
        }
    return weights;
}

std::vector<dvec3> samples(const std::vector<Corners>& surface, double spacing)
{
    std::vector<dvec3> points;
    for (const Corners& t : surface)
        for (const dvec3& w : samples(t, spacing)) points.push_back(t[0] * w[0] + t[1] * w[1] + t[2] * w[2]);
    return points;
}
}
