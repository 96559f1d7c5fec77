#include "baker/cuts.hpp"
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <unordered_map>

namespace afterglow
{
namespace
{
using Ring = std::vector<dvec3>; // convex, counterclockwise
using Numbers = std::vector<uint>;

// Points by number; what lies nearer than `same` to one of them is that one.
class Points
{
public:
    Points(std::vector<dvec3>& points, double same) : points_(points), same_(same) {}

    uint at(const dvec3& p)
    {
        for (int corner = 0; corner < 8; corner++) {
            const auto found = cells_.find(cellOf(p + same_ * dvec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1)));
            if (found == cells_.end()) continue;
            for (uint i : found->second)
                if (distance(points_[i], p) <= same_) return i;
        }
        points_.push_back(p);
        cells_[cellOf(p)].push_back(uint(points_.size() - 1));
        return uint(points_.size() - 1);
    }

private:
    std::uint64_t cellOf(const dvec3& p) const // strangers that share its number are told apart by their distance
    {
        std::uint64_t cell = 0;
        for (int axis = 0; axis < 3; axis++)
            cell = (cell ^ std::uint64_t(std::int64_t(std::floor(p[axis] / (8.0 * same_))))) * 0x9E3779B97F4A7C15u;
        return cell;
    }

    std::vector<dvec3>& points_;
    std::unordered_map<std::uint64_t, Numbers> cells_;
    double same_;
};

// How far along a line a point lies that is on it, 0 to 1; less than 0: it is not.
double along(const dvec3& from, const dvec3& to, const dvec3& p, double same)
{
    const dvec3 way = to - from;
    const double t = clamp(dot(p - from, way) / max(dot(way, way), 1e-300), 0.0, 1.0);
    return distance(from + t * way, p) <= same ? t : -1.0;
}

// The two parts of a ring on either side of a line through it; one alone when it runs along its edge.
std::vector<Ring> parted(const Ring& ring, const Line& line, const dvec3& normal, double same)
{
    const dvec3 left = normalize(cross(normal, line.to - line.from));
    std::vector<double> height;
    for (const dvec3& p : ring) {
        const double h = dot(p - line.from, left);
        height.push_back(abs(h) <= same ? 0.0 : h);
    }
    const auto [least, most] = std::minmax_element(height.begin(), height.end());
    if (!(*least < 0.0 && *most > 0.0)) return {ring};
    std::vector<Ring> parts;
    for (double side : {1.0, -1.0}) {
        Ring& part = parts.emplace_back();
        for (std::size_t i = 0; i < ring.size(); i++) {
            const std::size_t next = (i + 1) % ring.size();
            const double a = side * height[i], b = side * height[next];
            if (a >= 0.0) part.push_back(ring[i]);
            if (a * b < 0.0) part.push_back(side > 0.0 ? mix(ring[i], ring[next], a / (a - b)) : mix(ring[next], ring[i], b / (b - a)));
        }
    }
    return parts;
}

// A ring with those of the points that lie on its sides.
Numbers withPointsOnSides(const Numbers& ring, const Numbers& candidates, const std::vector<dvec3>& points, double same)
{
    Numbers result;
    for (std::size_t i = 0; i < ring.size(); i++) {
        const uint from = ring[i], to = ring[(i + 1) % ring.size()];
        if (from == to) continue;
        std::vector<std::pair<double, uint>> on;
        for (uint c : candidates)
            if (c != from && c != to)
                if (const double t = along(points[from], points[to], points[c], same); t > 0.0 && t < 1.0) on.push_back({t, c});
        std::sort(on.begin(), on.end());
        result.push_back(from);
        for (const auto& [t, c] : on)
            if (c != result.back()) result.push_back(c);
    }
    return result;
}

// Triangles of a ring whose sides may hold points: a fan about one of its corners, or about its middle where every corner would give some
// without area.
void fan(const Numbers& ring, uint parent, double same, CutMesh& out)
{
    const std::size_t n = ring.size();
    for (std::size_t apex = 0; apex < n; apex++) {
        bool flat = n < 3;
        for (std::size_t i = 1; i + 1 < n; i++) {
            const dvec3 &a = out.points[ring[apex]], &b = out.points[ring[(apex + i) % n]], &c = out.points[ring[(apex + i + 1) % n]];
            const double longest = max(max(distance(a, b), distance(b, c)), distance(c, a));
            flat = flat || length(cross(b - a, c - a)) <= same * longest;
        }
        if (flat) continue;
        for (std::size_t i = 1; i + 1 < n; i++)
            out.triangles.push_back({{ring[apex], ring[(apex + i) % n], ring[(apex + i + 1) % n]}, parent});
        return;
    }
    if (n <= 3) return; // a line: its sides are its neighbours'
    dvec3 middle(0.0);
    for (uint p : ring) middle += out.points[p] / double(n);
    out.points.push_back(middle);
    for (std::size_t i = 0; i < n; i++) out.triangles.push_back({{uint(out.points.size() - 1), ring[i], ring[(i + 1) % n]}, parent});
}
}

bool isOn(const Line& line, const dvec3& point, double same) { return along(line.from, line.to, point, same) >= 0.0; }

CutMesh cutAlong(std::span<const Corners> triangles, std::span<const Lines> lines, double same)
{
    CutMesh result;
    Points points(result.points, same);
    std::vector<std::array<uint, 3>> corners;
    for (const Corners& t : triangles) corners.push_back({points.at(t[0]), points.at(t[1]), points.at(t[2])});

    // Part the triangles, each for itself
    std::vector<std::vector<Numbers>> rings(triangles.size());
    std::map<Side, Numbers> pointsOn; // of the mesh's own sides
    for (std::size_t t = 0; t < triangles.size(); t++) {
        if (lines[t].empty()) continue;
        const dvec3 normal = normalOf(triangles[t]);
        std::vector<Ring> parts{{triangles[t][0], triangles[t][1], triangles[t][2]}};
        for (const Line& line : lines[t]) {
            std::vector<Ring> finer;
            for (const Ring& ring : parts)
                if (within(line, ring, normal, same))
                    for (Ring& part : parted(ring, line, normal, same)) finer.push_back(std::move(part));
                else
                    finer.push_back(ring);
            parts = std::move(finer);
        }
        for (const Ring& ring : parts) {
            Numbers& numbers = rings[t].emplace_back();
            for (const dvec3& p : ring) {
                numbers.push_back(points.at(p));
                for (std::size_t i = 0; i < 3; i++) {
                    const uint a = corners[t][i], b = corners[t][(i + 1) % 3];
                    const double place = along(result.points[a], result.points[b], p, same);
                    if (place > 0.0 && place < 1.0) pointsOn[sideOf(a, b)].push_back(numbers.back());
                }
            }
        }
    }

    // Give every side all points that lie on it, and lay triangles
    for (uint t = 0; t < triangles.size(); t++) {
        Numbers candidates;
        for (const Numbers& ring : rings[t]) candidates.insert(candidates.end(), ring.begin(), ring.end());
        for (std::size_t i = 0; i < 3; i++)
            if (const auto on = pointsOn.find(sideOf(corners[t][i], corners[t][(i + 1) % 3])); on != pointsOn.end())
                candidates.insert(candidates.end(), on->second.begin(), on->second.end());
        if (candidates.empty()) {
            result.triangles.push_back({{corners[t][0], corners[t][1], corners[t][2]}, t});
            continue;
        }
        std::sort(candidates.begin(), candidates.end());
        candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
        if (rings[t].empty()) rings[t].push_back({corners[t].begin(), corners[t].end()});
        for (const Numbers& ring : rings[t]) {
            const Numbers whole = withPointsOnSides(ring, candidates, result.points, same);
            for (std::size_t i = 0; i < whole.size(); i++) {
                const uint a = whole[i], b = whole[(i + 1) % whole.size()];
                const dvec3 middle = 0.5 * (result.points[a] + result.points[b]);
                if (std::any_of(lines[t].begin(), lines[t].end(), [&](const Line& line) { return isOn(line, middle, 2.0 * same); }))
                    result.onLines.insert(sideOf(a, b));
            }
            fan(whole, t, same, result);
        }
    }
    return result;
}
}
