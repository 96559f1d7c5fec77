#include "baker/atlas_unroll.hpp"
#include "baker/atlas_net.hpp"
#include "baker/atlas_rigid.hpp"
#include "baker/sets.hpp"
#include "engine/core/interrupt.hpp"
#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <map>
#include <numeric>
#include <queue>
#include <tuple>

namespace afterglow
{
namespace
{
constexpr double kStretch = 1.01;      // Sander's L2 of a joined chart
constexpr double kWorst = 2.0;         // and of a triangle in it: longest over shortest
constexpr double kRigid = 1.0002;      // Sander's L2 of a net that turning and solving would not better
constexpr double kRigidWorst = 1.02;   // and of a triangle in it
constexpr double kCurved = 0.08;       // least variance of a joined chart's normals along any direction; 0.083: a hemisphere
constexpr double kDevelopable = 0.005; // below it, cylinders and cones
constexpr double kRuled = 1e-6;        // of that variance: a piece of a cylinder or a cone, which lies flat of its own accord
constexpr double kRough = 1.05;        // how far two charts merely laid together may be from that: at 1.2 half of the solving was in vain
constexpr double kFilled = 0.55;       // of its rectangle, a joined chart fills as much: tried 0.35 to 0.8
constexpr double kBlobFilled = 0.66;   // and one that is curved and large, or others find no room around it: tried 0.6 to 0.8
constexpr double kLarge = 0.15;        // of the longest that is allowed: large
constexpr double kFlat = 0.98;         // of a part's area, what its mean normal sees of it: as good as one plane; 0.95 costs the bunny
                                       // 1.5 points of its page
constexpr double kCrease = 0.7;        // cosine between two of them

struct Part {
    Net net;                                           // empty: joined to another
    std::vector<uint> borders;                         // corners where a side starts that another chart continues
    uint joins = 0;                                    // of others to it
    double area = 0.0;                                 // m2
    dvec3 normal{0.0};                                 // sum of area * normal
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero(); // sum of area * normal normal^T
};

struct Candidate {
    double rank;
    uint a, b;
    uint joins; // of both, when they were offered: one that has grown since is offered anew
    bool operator<(const Candidate& other) const { return std::tie(rank, other.a, other.b) < std::tie(other.rank, a, b); }
};

class Parts
{
public:
    Parts(const Surface& surface, const std::vector<uint>& across, const std::vector<FlatChart>& charts, const UnrollOptions& options)
        : surface_(surface), across_(across), options_(options), partOf_(surface.triangles()), place_(surface.triangles())
    {
        for (const FlatChart& chart : charts) {
            for (std::size_t i = 0; i < chart.triangles.size(); ++i)
                partOf_[chart.triangles[i]] = uint(parts_.size()), place_[chart.triangles[i]] = uint(i);
            parts_.emplace_back();
        }
        for (uint c = 0; c < charts.size(); ++c) parts_[c] = partFrom(charts[c], c);
    }

    void join()
    {
        std::priority_queue<Candidate> queue;
        const auto offer = [&](uint a, uint from) {
            for (const auto& [b, shared] : sharedWith(a))
                if (b >= from)
                    queue.push(
                        {shared / std::sqrt(min(parts_[a].area, parts_[b].area)), min(a, b), max(a, b), parts_[a].joins + parts_[b].joins});
        };
        for (uint a = 0; a < parts_.size(); ++a) offer(a, a);
        while (!queue.empty()) {
            stopIfInterrupted();
            const Candidate next = queue.top();
            queue.pop();
            const Part &a = parts_[next.a], &b = parts_[next.b];
            if (a.net.triangles.empty() || b.net.triangles.empty() || a.joins + b.joins != next.joins) continue;
            if (joinInto(next.a, next.b)) offer(next.a, 0);
        }
    }

    std::vector<FlatChart> charts() const
    {
        std::vector<FlatChart> result;
        std::vector<std::size_t> chartOf(parts_.size());
        for (std::size_t p = 0; p < parts_.size(); ++p)
            if (!parts_[p].net.triangles.empty()) chartOf[p] = result.size(), result.emplace_back();
        std::vector<uint> place(surface_.triangles()); // in the chart
        for (uint t = 0; t < surface_.triangles(); ++t) {
            FlatChart& chart = result[chartOf[partOf_[t]]];
            const Net& net = parts_[partOf_[t]].net;
            place[t] = uint(chart.triangles.size());
            chart.triangles.push_back(t);
            for (uint k = 0; k < 3; ++k) chart.shape.push_back(net.points[net.vertex[3 * place_[t] + k]]);
        }
        for (uint p = 0; p < parts_.size(); ++p) {
            const Net& net = parts_[p].net;
            const auto placeOf = [&](uint t) { return partOf_[t] == p ? place_[t] : kNoTriangle; };
            for (const uint corner : rimOf(net, placeOf))
                result[chartOf[p]].rim.push_back(3 * place[net.triangles[corner / 3]] + corner % 3);
        }
        return result;
    }

private:
    Part partFrom(const FlatChart& chart, uint c)
    {
        Part part;
        part.net.triangles = chart.triangles;
        Sets sets(chart.shape.size());
        for (uint i = 0; i < chart.triangles.size(); ++i) {
            const uint t = chart.triangles[i];
            const dvec3& n = surface_.normals[t];
            part.area += surface_.areas[t], part.normal += surface_.areas[t] * n;
            for (int x = 0; x < 3; ++x)
                for (int y = 0; y < 3; ++y) part.scatter(x, y) += surface_.areas[t] * n[x] * n[y];
            for (uint k = 0; k < 3; ++k) {
                const uint across = across_[3 * t + k];
                if (across == kNoCorner) continue;
                if (partOf_[across / 3] != c) {
                    part.borders.push_back(3 * t + k);
                    continue;
                }
                const uint other = 3 * place_[across / 3];
                sets.join(3 * i + k, other + (across + 1) % 3);
                sets.join(3 * i + (k + 1) % 3, other + across % 3);
            }
        }
        std::vector<uint> order(chart.shape.size()); // along the chart
        std::iota(order.begin(), order.end(), 0u);
        std::sort(order.begin(), order.end(),
                  [&](uint a, uint b) { return chart.shape[a].x != chart.shape[b].x ? chart.shape[a].x < chart.shape[b].x : a < b; });
        number(part.net, sets, chart.shape, order);
        if (curvature(part, part) < kRuled && !isRigid(normalise(surface_, part.net)))
            relax(surface_, part.net), normalise(surface_, part.net);
        return part;
    }

    double lengthOf(uint corner) const
    {
        const uint t = corner / 3, k = corner % 3;
        return distance(surface_.point(t, int(k)), surface_.point(t, int((k + 1) % 3)));
    }

    bool smooth(uint corner) const
    {
        const dvec3 &m = surface_.normals[corner / 3], &n = surface_.normals[across_[corner] / 3];
        return m != dvec3(0.0) && n != dvec3(0.0) && dot(m, n) >= kCreaseCosine;
    }

    // Lengths of the smooth borders with others, m.
    std::map<uint, double> sharedWith(uint a) const
    {
        std::map<uint, double> shared;
        for (uint corner : parts_[a].borders)
            if (const uint b = partOf_[across_[corner] / 3]; b != a && smooth(corner)) shared[b] += lengthOf(corner);
        return shared;
    }

    // The least variance of the normals along any direction.
    double curvature(const Part& a, const Part& b) const
    {
        const double area = a.area + b.area;
        const dvec3 mean = (a.normal + b.normal) / area;
        Eigen::Matrix3d variance = (a.scatter + b.scatter) / area;
        for (int x = 0; x < 3; ++x)
            for (int y = 0; y < 3; ++y) variance(x, y) -= mean[x] * mean[y];
        return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(variance, Eigen::EigenvaluesOnly).eigenvalues()[0];
    }

    // The longest run of smooth sides between a and b, as corners of a.
    std::vector<uint> seam(uint a, uint b) const
    {
        std::vector<uint> sides;
        for (uint corner : parts_[a].borders)
            if (partOf_[across_[corner] / 3] == b && smooth(corner)) sides.push_back(corner);
        std::map<uint, uint> first; // per vertex of a: the first side that touches it
        Sets runs(sides.size());
        for (uint i = 0; i < sides.size(); ++i)
            for (uint end : {sides[i] % 3, (sides[i] % 3 + 1) % 3}) {
                const auto [entry, isNew] = first.try_emplace(parts_[a].net.vertex[3 * place_[sides[i] / 3] + end], i);
                if (!isNew) runs.join(i, entry->second);
            }
        std::map<uint, double> lengths;
        for (uint i = 0; i < sides.size(); ++i) lengths[runs.root(i)] += lengthOf(sides[i]);
        if (lengths.empty()) return {};
        const uint longest =
            std::max_element(lengths.begin(), lengths.end(), [](const auto& x, const auto& y) { return x.second < y.second; })->first;
        std::vector<uint> result;
        for (uint i = 0; i < sides.size(); ++i)
            if (runs.root(i) == longest) result.push_back(sides[i]);
        return result;
    }

    // Both in one net, sewn along the run.
    Net sewn(uint a, uint b, const std::vector<uint>& run) const
    {
        std::vector<std::pair<uint, uint>> ends;
        for (uint corner : run) {
            const uint across = across_[corner], here = 3 * place_[corner / 3], there = 3 * place_[across / 3];
            ends.push_back({here + corner % 3, there + (across + 1) % 3});
            ends.push_back({here + (corner + 1) % 3, there + across % 3});
        }
        return afterglow::sewn(parts_[a].net, parts_[b].net, ends);
    }

    // The corners of a net at which its border's sides start. `placeOf`: of a triangle in it, kNoTriangle if it is in another.
    template <typename PlaceOf>
    std::vector<uint> rimOf(const Net& net, PlaceOf placeOf) const
    {
        std::vector<uint> rim;
        for (uint corner = 0; corner < net.vertex.size(); ++corner) {
            const uint across = across_[3 * net.triangles[corner / 3] + corner % 3],
                       place = across == kNoCorner ? kNoTriangle : placeOf(across / 3);
            if (place == kNoTriangle || net.vertex[corner] != net.vertex[3 * place + (across + 1) % 3] ||
                net.vertex[nextCorner(corner)] != net.vertex[3 * place + across % 3])
                rim.push_back(corner);
        }
        return rim;
    }

    // Flat parts that turn by more than 45 degrees, as over a bevel: no texel is fine enough to tell the light of one from that of the other.
    static bool isCrease(const Part& a, const Part& b)
    {
        const double one = length(a.normal), other = length(b.normal);
        return one > kFlat * a.area && other > kFlat * b.area && dot(a.normal, b.normal) < kCrease * one * other;
    }

    static bool isRigid(const Strain& strain) { return !strain.flipped && strain.stretch < kRigid && strain.worst < kRigidWorst; }

    bool joinInto(uint a, uint b)
    {
        Part &into = parts_[a], &from = parts_[b];
        if (isCrease(into, from)) return false;
        const double curved = curvature(into, from);
        if (curved > kCurved) return false;
        const std::vector<uint> run = seam(a, b);
        if (run.empty()) return false;

        Net net = sewn(a, b, run);
        const auto compact = [&](double tolerance) {
            const dvec2 extent = turnToSmallestRectangle(net.points);
            const double filled = curved > kDevelopable && extent.x > kLarge * options_.longest ? kBlobFilled : kFilled;
            return extent.x < tolerance * options_.longest && into.area + from.area > filled * extent.x * extent.y / tolerance;
        };
        if (!compact(kRough)) return false; // before the work
        Strain strain = normalise(surface_, net);
        if (!isRigid(strain)) relax(surface_, net), strain = normalise(surface_, net);
        if (strain.flipped || strain.stretch > kStretch || strain.worst > kWorst || !compact(1.0)) return false;
        std::vector<dvec2> shape;
        for (uint v : net.vertex) shape.push_back(net.points[v]);
        const uint shift = uint(into.net.triangles.size()); // of the other's triangles
        const auto placeOf = [&](uint t) { return partOf_[t] == a ? place_[t] : partOf_[t] == b ? shift + place_[t] : kNoTriangle; };
        if (foldsOver(shape, rimOf(net, placeOf), 0.5 * options_.texel)) return false;

        for (std::size_t i = into.net.triangles.size(); i < net.triangles.size(); ++i)
            place_[net.triangles[i]] = uint(i), partOf_[net.triangles[i]] = a;
        into.net = std::move(net);
        ++into.joins;
        into.area += from.area, into.normal += from.normal, into.scatter += from.scatter;
        into.borders.insert(into.borders.end(), from.borders.begin(), from.borders.end());
        std::erase_if(into.borders, [&](uint corner) { return partOf_[across_[corner] / 3] == a; });
        from = Part();
        return true;
    }

    const Surface& surface_;
    const std::vector<uint>& across_;
    const UnrollOptions options_;
    std::vector<uint> partOf_, place_; // per triangle
    std::vector<Part> parts_;
};
}

std::vector<FlatChart> unroll(const Surface& surface, const std::vector<uint>& across, std::vector<FlatChart> charts,
                              const UnrollOptions& options)
{
    Parts parts(surface, across, charts, options);
    parts.join();
    return parts.charts();
}
}
