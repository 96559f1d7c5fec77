#include "baker/atlas_charts.hpp"
#include "baker/half_edges.hpp"
#include <algorithm>
#include <numeric>
#include <queue>

namespace afterglow
{
namespace
{
constexpr double kCreaseCosine = 0.8; // two faces that meet at more than 37 degrees: light breaks there, and so do charts
constexpr double kMeanCosine = 0.9;   // of a chart's triangles and its axis, by area: a spherical cap of 37 degrees
constexpr double kSmallTexels = 16.0; // charts below this area may join over creases

// Every normal of a chart lies within `angle` of `axis`; negative: no normal yet.
struct Cone {
    dvec3 axis{0.0};
    double angle = -1.0;
};

double angleBetween(const dvec3& a, const dvec3& b) { return std::acos(std::clamp(dot(a, b), -1.0, 1.0)); }

Cone enclose(const Cone& a, const Cone& b)
{
    if (b.angle < 0.0) return a;
    if (a.angle < 0.0) return b;
    double between = angleBetween(a.axis, b.axis);
    if (between + b.angle <= a.angle) return a;
    if (between + a.angle <= b.angle) return b;
    double angle = (a.angle + between + b.angle) / 2;
    if (between < 1e-9) return {a.axis, angle};
    double turn = (angle - a.angle) / between; // from a's axis towards b's
    dvec3 axis = (std::sin((1 - turn) * between) * a.axis + std::sin(turn * between) * b.axis) / std::sin(between);
    return {normalize(axis), angle};
}

struct Cluster {
    dvec3 normal; // sum of area * unit normal, m2
    double area;  // m2
    Cone cone;
};

Cluster merged(const Cluster& a, const Cluster& b) { return {a.normal + b.normal, a.area + b.area, enclose(a.cone, b.cone)}; }

// The energy that the merger adds: sum of area * (1 - cos(normal, axis)) over the triangles, m2.
double cost(const Cluster& a, const Cluster& b) { return max(length(a.normal) + length(b.normal) - length(a.normal + b.normal), 0.0); }

// One plane sees the whole cluster: no triangle too steep, and few steep ones.
bool flat(const Cluster& c)
{
    double size = length(c.normal);
    if (c.cone.angle < 0.0) return true;
    return size >= kMeanCosine * c.area && angleBetween(c.normal / size, c.cone.axis) + c.cone.angle <= std::acos(kFlattestCosine);
}

struct Border { // between two triangles
    double cost;
    uint a, b;
    bool operator<(const Border& other) const // cheapest first from a priority queue, in a stated order
    {
        return std::tie(cost, a, b) > std::tie(other.cost, other.a, other.b);
    }
};

class Clusters
{
public:
    explicit Clusters(const Surface& surface) : parent(surface.triangles())
    {
        std::iota(parent.begin(), parent.end(), 0u);
        for (uint t = 0; t < surface.triangles(); ++t) {
            const dvec3& n = surface.normals[t];
            bool degenerate = n == dvec3(0.0);
            clusters.push_back({surface.areas[t] * n, surface.areas[t], degenerate ? Cone{} : Cone{n, 0.0}});
        }
    }

    uint root(uint t)
    {
        while (parent[t] != t) t = parent[t] = parent[parent[t]];
        return t;
    }

    // Merges over the given borders, cheapest first, as long as one plane sees the result and `wanted` agrees. A border's price only
    // rises while its sides grow, so it is asked again when its turn comes rather than at every change.
    template <typename Wanted>
    void merge(const std::vector<Border>& borders, Wanted wanted)
    {
        std::priority_queue<Border> queue;
        for (const Border& border : borders) price(queue, border.a, border.b, wanted);
        while (!queue.empty()) {
            Border border = queue.top();
            queue.pop();
            uint a = root(border.a), b = root(border.b);
            if (a == b) continue;
            if (cost(clusters[a], clusters[b]) > border.cost * (1 + 1e-6) + 1e-12 * (clusters[a].area + clusters[b].area)) {
                price(queue, a, b, wanted);
                continue;
            }
            Cluster whole = merged(clusters[a], clusters[b]);
            if (!flat(whole) || !wanted(clusters[a], clusters[b])) continue;
            parent[max(a, b)] = min(a, b);
            clusters[min(a, b)] = whole;
        }
    }

private:
    template <typename Wanted>
    void price(std::priority_queue<Border>& queue, uint a, uint b, Wanted wanted)
    {
        a = root(a), b = root(b);
        if (a != b && wanted(clusters[a], clusters[b])) queue.push({cost(clusters[a], clusters[b]), min(a, b), max(a, b)});
    }

    std::vector<uint> parent;
    std::vector<Cluster> clusters; // valid at roots
};

std::vector<uint> acrossSides(const Surface& surface, int& partedEdges)
{
    Weld welded = weld(surface.keys, surface.indices);
    partedEdges = welded.partedEdges;
    HalfEdgeMesh sheets = halfEdges(welded, surface.points, surface.indices);
    std::vector<uint> neighbours(surface.indices.size(), kNoTriangle);
    for (uint corner = 0; corner < surface.indices.size(); ++corner) {
        uint point = welded.point[surface.indices[corner]];
        for (auto side : sheets.mesh.fh_range(HalfEdges::FaceHandle(int(corner / 3)))) {
            if (sheets.point[sheets.mesh.from_vertex_handle(side).idx()] != point) continue;
            auto face = sheets.mesh.opposite_face_handle(side);
            if (face.is_valid()) neighbours[corner] = uint(face.idx());
        }
    }
    return neighbours;
}
}

Charts growCharts(const Surface& surface, double texel)
{
    Charts result;
    result.neighbours = acrossSides(surface, result.partedEdges);

    std::vector<Border> smooth, all;
    for (uint corner = 0; corner < surface.indices.size(); ++corner) {
        uint a = corner / 3, b = result.neighbours[corner];
        if (b == kNoTriangle || b < a) continue;
        bool degenerate = surface.normals[a] == dvec3(0.0) || surface.normals[b] == dvec3(0.0);
        bool crease = !degenerate && dot(surface.normals[a], surface.normals[b]) < kCreaseCosine;
        all.push_back({0.0, a, b});
        if (!crease) smooth.push_back({0.0, a, b});
    }

    Clusters clusters(surface);
    clusters.merge(smooth, [](const Cluster&, const Cluster&) { return true; });
    double small = kSmallTexels * texel * texel;
    clusters.merge(all, [=](const Cluster& a, const Cluster& b) { return min(a.area, b.area) < small; });

    std::vector<uint> chartOf(surface.triangles(), ~0u);
    for (uint t = 0; t < surface.triangles(); ++t) {
        uint& chart = chartOf[clusters.root(t)];
        if (chart == ~0u) {
            chart = uint(result.charts.size());
            result.charts.emplace_back();
        }
        result.charts[chart].push_back(t);
    }
    return result;
}
}
