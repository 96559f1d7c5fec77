#include "baker/atlas_borders.hpp"
#include "baker/atlas_charts.hpp"
#include "engine/core/interrupt.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace afterglow
{
namespace
{
struct Weights {
    double spread; // of a chart, beside its bend
    double border; // its length
};

// First the teeth that growing left, or they hold borders back; then round charts; then the teeth of the new borders. Of the second, 0.3 to
// 16 and 0 to 2 were tried on five meshes, curved and turned: their ratio decides.
constexpr std::array<Weights, 3> kRounds{Weights{0.0, 1.0}, Weights{4.0, 0.2}, Weights{0.0, 1.0}};
constexpr int kSweeps = 30;          // over the borders, in a round; most rest after fewer
constexpr double kLess = 1e-9;       // of a triangle's area: by so much a move must lower the cost, or rounding alone would go on
constexpr double kLeastArea = 1e-30; // m2

constexpr double kFlatEnough = kFlattestCosine + 0.1; // of a triangle that goes over to another chart, whose axis may yet turn

struct Disc { // a chart, as a triangle at its border sees it
    dvec3 normal{0.0}, moment{0.0};
    double area = 0.0; // m2
    dvec3 axis{0.0}, centre{0.0};

    void add(double triangle, const dvec3& n, const dvec3& at) // a negative area takes it away
    {
        normal += triangle * n, moment += triangle * at, area += triangle;
        axis = length(normal) > 0.0 ? normalize(normal) : dvec3(0.0);
        centre = area > kLeastArea ? moment / area : at;
    }
};

class Borders
{
public:
    Borders(const Surface& surface, const std::vector<uint>& neighbours, std::vector<uint>& chartOf)
        : surface_(surface), neighbours_(neighbours), chartOf_(chartOf), discs_(1 + *std::max_element(chartOf.begin(), chartOf.end()))
    {
        for (uint t = 0; t < surface.triangles(); ++t) discs_[chartOf[t]].add(surface.areas[t], surface.normals[t], centre(t));
    }

    void settle(const Weights& weights)
    {
        std::vector<uint> waiting(surface_.triangles()), next;
        std::iota(waiting.begin(), waiting.end(), 0u);
        std::vector<int> asked(surface_.triangles());
        for (int sweep = 1; sweep <= kSweeps && !waiting.empty(); ++sweep, waiting = std::move(next), next.clear()) {
            stopIfInterrupted();
            const auto askAgain = [&](uint t) {
                if (t != kNoTriangle && asked[t] != sweep) asked[t] = sweep, next.push_back(t);
            };
            for (uint t : waiting)
                if (move(t, weights)) {
                    askAgain(t);
                    for (uint i = 0; i < 3; ++i) askAgain(neighbours_[3 * t + i]);
                }
        }
    }

    // What lies apart from the largest part of its chart goes where it shares most, if it is flat enough there. True if there was any: what
    // it went to may have been an island that has left since. It ends, for every island grows together with another part or gets an id.
    bool joinIslands()
    {
        std::vector<std::vector<uint>> parts = connected();
        std::vector<double> largest(discs_.size(), -1.0), areas;
        std::vector<std::size_t> partOf(discs_.size());
        for (std::size_t p = 0; p < parts.size(); ++p) {
            const uint chart = chartOf_[parts[p][0]];
            areas.push_back(0.0);
            for (uint t : parts[p]) areas[p] += surface_.areas[t];
            if (areas[p] > largest[chart]) largest[chart] = areas[p], partOf[chart] = p;
        }
        std::vector<std::size_t> islands;
        for (std::size_t p = 0; p < parts.size(); ++p)
            if (partOf[chartOf_[parts[p][0]]] != p) islands.push_back(p);
        for (std::size_t p : islands) {
            const uint chart = hostOf(parts[p]);
            for (uint t : parts[p]) chartOf_[t] = chart;
            if (chart == discs_.size()) discs_.emplace_back();
        }
        return !islands.empty();
    }

private:
    dvec3 centre(uint t) const { return (surface_.point(t, 0) + surface_.point(t, 1) + surface_.point(t, 2)) / 3.0; }

    double side(uint t, uint i) const { return distance(surface_.point(t, int(i)), surface_.point(t, int(i + 1) % 3)); }

    // The chart across a side where the surface goes on without a crease.
    uint chartAcross(uint t, uint i) const
    {
        const uint n = neighbours_[3 * t + i];
        return n == kNoTriangle || dot(surface_.normals[t], surface_.normals[n]) < kCreaseCosine ? kNoTriangle : chartOf_[n];
    }

    bool flatIn(uint t, uint chart) const
    {
        return surface_.normals[t] == dvec3(0.0) || dot(surface_.normals[t], discs_[chart].axis) >= kFlatEnough;
    }

    // Hands the triangle to the chart across one of its sides if it costs less there, m2: area * (1 - cos(normal, axis)), its share of the
    // chart's spread, less the border that it saves.
    bool move(uint t, const Weights& weights)
    {
        const uint from = chartOf_[t];
        const std::array<uint, 3> across{chartAcross(t, 0), chartAcross(t, 1), chartAcross(t, 2)};
        const bool atBorder = std::any_of(across.begin(), across.end(), [&](uint chart) { return chart != kNoTriangle && chart != from; });
        if (!atBorder || surface_.normals[t] == dvec3(0.0)) return false;

        const double area = surface_.areas[t];
        const dvec3 &normal = surface_.normals[t], at = centre(t);
        const std::array<double, 3> sides{side(t, 0), side(t, 1), side(t, 2)};
        const auto cost = [&](uint chart) {
            const Disc& disc = discs_[chart];
            const dvec3 away = at - disc.centre;
            double inside = 0.0;
            for (std::size_t i = 0; i < 3; ++i) inside += across[i] == chart ? sides[i] : 0.0;
            return area * (1.0 - dot(normal, disc.axis) + weights.spread * dot(away, away) / max(disc.area, kLeastArea)) -
                   weights.border * std::sqrt(area) * inside;
        };
        uint to = from;
        double least = cost(from) - kLess * area;
        for (uint chart : across) {
            if (chart == kNoTriangle || chart == from || !flatIn(t, chart)) continue;
            if (const double there = cost(chart); there < least) least = there, to = chart;
        }
        if (to == from) return false;
        discs_[from].add(-area, normal, at), discs_[to].add(area, normal, at);
        chartOf_[t] = to;
        return true;
    }

    // The triangles of each chart, by what hangs together.
    std::vector<std::vector<uint>> connected() const
    {
        std::vector<std::vector<uint>> parts;
        std::vector<bool> done(surface_.triangles());
        for (uint first = 0; first < surface_.triangles(); ++first) {
            if (done[first]) continue;
            std::vector<uint>& part = parts.emplace_back(1, first);
            done[first] = true;
            for (std::size_t k = 0; k < part.size(); ++k)
                for (uint i = 0; i < 3; ++i) {
                    const uint n = neighbours_[3 * part[k] + i];
                    if (n == kNoTriangle || done[n] || chartOf_[n] != chartOf_[first]) continue;
                    done[n] = true;
                    part.push_back(n);
                }
        }
        return parts;
    }

    // An id that is free if no chart around suits all of the island.
    uint hostOf(const std::vector<uint>& island) const
    {
        std::map<uint, double> shared; // m
        for (uint t : island)
            for (uint i = 0; i < 3; ++i)
                if (const uint chart = chartAcross(t, i); chart != kNoTriangle && chart != chartOf_[t]) shared[chart] += side(t, i);
        uint host = uint(discs_.size());
        double most = 0.0;
        for (const auto& [chart, length] : shared)
            if (length > most && std::all_of(island.begin(), island.end(), [&, c = chart](uint t) { return flatIn(t, c); }))
                host = chart, most = length;
        return host;
    }

    const Surface& surface_;
    const std::vector<uint>& neighbours_;
    std::vector<uint>& chartOf_;
    std::vector<Disc> discs_; // per chart
};
}

void moveBorders(const Surface& surface, const std::vector<uint>& neighbours, std::vector<uint>& chartOf)
{
    if (chartOf.empty()) return;
    Borders borders(surface, neighbours, chartOf);
    for (const Weights& weights : kRounds) borders.settle(weights);
    while (borders.joinIslands()) {
    }
}
}
