#include "baker/atlas_charts.hpp"
#include "baker/atlas_borders.hpp"
#include "engine/core/interrupt.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <queue>
#include <set>
#include <tuple>

namespace afterglow
{
namespace
{
constexpr double kMeanCosine = 0.84;  // of a chart's triangles and its axis, by area: a spherical cap of 47 degrees; tried 0.8 to 0.9
constexpr double kRound = 0.3;        // weight of roundness beside flatness: tried 0, 0.02, 0.1, 0.3, 1, 3: fuller pages, more charts
constexpr double kSmallTexels = 16.0; // charts below this area may join over creases

double angleBetween(const dvec3& a, const dvec3& b) { return std::acos(std::clamp(dot(a, b), -1.0, 1.0)); }

struct Cluster {
    dvec3 normal;   // sum of area * unit normal, m2
    dvec3 moment;   // sum of area * centre, m3
    double area;    // m2
    dvec3 steepest; // a normal far from the axis, 0: none yet
    double angle;   // from the axis, no normal has a larger one
    double facing;  // length of `normal`
    uint last;      // of its triangles, which follow one another from the root
};

dvec3 axisOf(const Cluster& c) { return c.facing > 0.0 ? c.normal / c.facing : c.normal; }

// The energy that the merger adds, m2: sum of area * (1 - cos(normal, axis)) over the triangles, and how far the centres are apart, so
// that charts grow round. It decides the order of the mergers; when they end is decided by join().
double cost(const Cluster& a, const Cluster& b)
{
    double bend = max(a.facing + b.facing - length(a.normal + b.normal), 0.0);
    double area = a.area + b.area;
    if (!(a.area > 0.0 && b.area > 0.0)) return bend;
    dvec3 apart = a.moment / a.area - b.moment / b.area;
    return bend + kRound * (a.area / area) * (b.area / area) * dot(apart, apart);
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
    explicit Clusters(const Surface& surface) : surface_(surface), parent_(surface.triangles()), next_(surface.triangles(), kNoTriangle)
    {
        std::iota(parent_.begin(), parent_.end(), 0u);
        clusters_.reserve(surface.triangles());
        for (uint t = 0; t < surface.triangles(); ++t) {
            const double area = surface.areas[t];
            dvec3 centre = (surface.point(t, 0) + surface.point(t, 1) + surface.point(t, 2)) / 3.0;
            const dvec3 normal = area * surface.normals[t];
            clusters_.push_back({normal, area * centre, area, surface.normals[t], 0.0, length(normal), t});
        }
    }

    uint root(uint t)
    {
        while (parent_[t] != t) t = parent_[t] = parent_[parent_[t]];
        return t;
    }

    // Merges over the given borders, cheapest first, as long as one plane sees the result and `wanted` agrees. A border's price only
    // rises while its sides grow, so it is asked again when its turn comes rather than at every change.
    template <typename Wanted>
    void merge(const std::vector<Border>& borders, Wanted wanted, const Advance& advance)
    {
        refused_.clear();
        std::vector<Border> first;
        for (const Border& border : borders)
            if (const std::optional<Border> offer = priced(border.a, border.b, wanted)) first.push_back(*offer);
        std::priority_queue<Border> queue({}, std::move(first));
        while (!queue.empty()) {
            stopIfInterrupted();
            Border border = queue.top();
            queue.pop();
            uint a = root(border.a), b = root(border.b);
            if (a == b || refused_.contains({min(a, b), max(a, b)})) continue;
            if (cost(clusters_[a], clusters_[b]) > border.cost * (1 + 1e-6) + 1e-12 * (clusters_[a].area + clusters_[b].area)) {
                if (const std::optional<Border> offer = priced(a, b, wanted)) queue.push(*offer);
                continue;
            }
            if (!wanted(clusters_[a], clusters_[b])) continue;
            if (join(min(a, b), max(a, b)))
                advance(1);
            else
                refused_.insert({min(a, b), max(a, b)});
        }
    }

private:
    template <typename Wanted>
    std::optional<Border> priced(uint a, uint b, Wanted wanted)
    {
        a = root(a), b = root(b);
        if (a == b || !wanted(clusters_[a], clusters_[b])) return {};
        return Border{cost(clusters_[a], clusters_[b]), min(a, b), max(a, b)};
    }

    // Merges b into a if one plane sees the whole: no triangle too steep, and few steep ones.
    bool join(uint into, uint from)
    {
        Cluster &a = clusters_[into], &b = clusters_[from];
        const dvec3 normal = a.normal + b.normal;
        const double area = a.area + b.area, most = std::acos(kFlattestCosine);
        double angle = 0.0;
        dvec3 steepest = a.steepest;
        if (length(normal) > 0.0) {
            const dvec3 axis = normalize(normal);
            if (length(normal) < kMeanCosine * area) return false;
            auto steeper = [&](const dvec3& n) {
                return n != dvec3(0.0) && (steepest == dvec3(0.0) || dot(n, axis) < dot(steepest, axis));
            };
            if (steeper(b.steepest)) steepest = b.steepest;
            if (steepest != dvec3(0.0) && dot(steepest, axis) < kFlattestCosine) return false;
            // The axis has turned by so much from either side's; only if that leaves doubt is every triangle asked.
            angle = max(a.angle + angleBetween(axisOf(a), axis), b.angle + angleBetween(axisOf(b), axis));
            if (angle > most) {
                for (const uint side : {into, from})
                    for (uint t = side; t != kNoTriangle; t = next_[t])
                        if (steeper(surface_.normals[t])) steepest = surface_.normals[t];
                angle = angleBetween(steepest, axis);
                if (angle > most) return false;
            }
        }
        parent_[from] = into;
        next_[a.last] = from;
        a.last = b.last;
        a.normal = normal, a.moment += b.moment, a.area = area, a.steepest = steepest, a.angle = angle, a.facing = length(normal);
        return true;
    }

    const Surface& surface_;
    std::vector<uint> parent_, next_; // per triangle
    std::vector<Cluster> clusters_;   // valid at roots
    std::set<std::pair<uint, uint>> refused_;
};

// The sides across, within a piece.
std::vector<uint> acrossSides(const Surface& surface, const Weld& welded)
{
    std::vector<uint> result(surface.indices.size(), kNoCorner);
    for (uint corner = 0; corner < surface.indices.size(); ++corner) {
        const uint across = welded.across[corner];
        if (across == kNoCorner || across / 3 == corner / 3) continue; // a triangle of two points continues itself
        if (surface.pieces[corner / 3] == surface.pieces[across / 3]) result[corner] = across;
    }
    return result;
}
}

Charts growCharts(const Surface& surface, double texel, const Advance& advance)
{
    Charts result;
    const Weld welded = weld(surface.keys, surface.indices);
    result.partedEdges = welded.partedEdges;
    result.across = acrossSides(surface, welded);
    for (const uint across : result.across) result.neighbours.push_back(across == kNoCorner ? kNoTriangle : across / 3);

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
    clusters.merge(
        smooth, [](const Cluster&, const Cluster&) { return true; }, advance);
    double small = kSmallTexels * texel * texel;
    clusters.merge(
        all, [=](const Cluster& a, const Cluster& b) { return min(a.area, b.area) < small; }, advance);

    std::vector<uint> chartOf(surface.triangles()), idOf(surface.triangles(), ~0u);
    uint charts = 0;
    for (uint t = 0; t < surface.triangles(); ++t) {
        uint& id = idOf[clusters.root(t)];
        if (id == ~0u) id = charts++;
        chartOf[t] = id;
    }
    moveBorders(surface, result.neighbours, chartOf);
    for (uint t = 0; t < surface.triangles(); ++t) {
        if (chartOf[t] >= result.charts.size()) result.charts.resize(chartOf[t] + 1);
        result.charts[chartOf[t]].push_back(t);
    }
    std::erase_if(result.charts, [](const Triangles& chart) { return chart.empty(); });
    return result;
}
}
