#include "baker/atlas_flatten.hpp"
#include "engine/core/interrupt.hpp"
#include <algorithm>
#include <array>
#include <cmath>

namespace afterglow
{
namespace
{
constexpr double kOutset = 1.0 / 64;  // texels by which a border passes the centres it runs through: they are covered, whatever rounds
constexpr double kRectangular = 0.98; // area of a chart / area of its rectangle
constexpr double kSmallest = 0.25;    // texels along a chart, or float rounding closes it
constexpr double kFoldSpacing = 0.5;  // texels between the samples that look for folds

dvec3 axisOf(const Surface& surface, const Triangles& triangles)
{
    dvec3 sum(0.0);
    for (uint t : triangles) sum += surface.areas[t] * surface.normals[t];
    double size = length(sum);
    return size > 0.0 ? sum / size : dvec3(0.0, 1.0, 0.0);
}

// Seen along the axis, counter-clockwise where the surface faces the viewer; scaled so that the area is the surface's own.
std::vector<dvec2> project(const Surface& surface, const Triangles& triangles, const dvec3& axis)
{
    dvec3 helper = std::abs(axis.y) < 0.9 ? dvec3(0.0, 1.0, 0.0) : dvec3(1.0, 0.0, 0.0);
    dvec3 right = normalize(cross(helper, axis)), up = cross(axis, right);
    double area = 0.0, seen = 0.0;
    for (uint t : triangles) {
        area += surface.areas[t];
        seen += surface.areas[t] * dot(surface.normals[t], axis);
    }
    double scale = seen > 0.0 ? std::sqrt(area / seen) : 1.0;
    dvec3 origin = surface.point(triangles[0], 0);
    std::vector<dvec2> corners;
    corners.reserve(3 * triangles.size());
    for (uint t : triangles)
        for (int i = 0; i < 3; ++i) {
            dvec3 p = (surface.point(t, i) - origin) * scale;
            corners.emplace_back(dot(p, right), dot(p, up));
        }
    return corners;
}

bool tooSteep(const Surface& surface, const Triangles& triangles, const dvec3& axis)
{
    return std::any_of(triangles.begin(), triangles.end(),
                       [&](uint t) { return surface.normals[t] != dvec3(0.0) && dot(surface.normals[t], axis) < kFlattestCosine - 1e-6; });
}

// The triangles reached first from the first one, half of them; and the pieces that remain.
std::vector<Triangles> halve(const Triangles& triangles, const std::vector<uint>& neighbours)
{
    std::vector<Triangles> pieces;
    std::vector<bool> done(triangles.size());
    auto place = [&](uint t) { return std::lower_bound(triangles.begin(), triangles.end(), t) - triangles.begin(); };
    for (std::size_t first = 0; first < triangles.size(); ++first) {
        if (done[first]) continue;
        Triangles piece{triangles[first]};
        done[first] = true;
        std::size_t limit = pieces.empty() ? (triangles.size() + 1) / 2 : triangles.size();
        for (std::size_t next = 0; next < piece.size() && piece.size() < limit; ++next)
            for (uint side = 0; side < 3 && piece.size() < limit; ++side) {
                uint t = neighbours[3 * piece[next] + side];
                std::ptrdiff_t i = place(t);
                if (t == kNoTriangle || i == std::ptrdiff_t(triangles.size()) || triangles[std::size_t(i)] != t || done[std::size_t(i)])
                    continue;
                done[std::size_t(i)] = true;
                piece.push_back(t);
            }
        std::sort(piece.begin(), piece.end());
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

// The corners of a chart at which its border's sides start. `chartOf`: any numbers, alike for its triangles alone.
std::vector<uint> rimOf(const Triangles& triangles, const std::vector<uint>& neighbours, const std::vector<uint>& chartOf)
{
    std::vector<uint> rim;
    for (uint corner = 0; corner < 3 * triangles.size(); ++corner) {
        const uint t = triangles[corner / 3], across = neighbours[3 * t + corner % 3];
        if (across == kNoTriangle || chartOf[across] != chartOf[t]) rim.push_back(corner);
    }
    return rim;
}

double cross2(const dvec2& a, const dvec2& b) { return a.x * b.y - a.y * b.x; }

// Drops most points that are no corners of the hull: those inside the extremes of eight directions (Akl, Toussaint 1978).
void dropInner(std::vector<dvec2>& points)
{
    std::array<double, 8> farthest;
    farthest.fill(-1e300);
    std::array<dvec2, 8> extreme{}; // counter-clockwise
    for (const dvec2& p : points) {
        const std::array<double, 8> far{p.x, p.x + p.y, p.y, p.y - p.x, -p.x, -p.x - p.y, -p.y, p.x - p.y};
        for (std::size_t k = 0; k < 8; ++k)
            if (far[k] > farthest[k]) farthest[k] = far[k], extreme[k] = p;
    }
    std::array<dvec2, 8> side; // from each to the next
    for (std::size_t k = 0; k < 8; ++k) side[k] = extreme[(k + 1) % 8] - extreme[k];
    std::erase_if(points, [&](const dvec2& p) {
        for (std::size_t k = 0; k < 8; ++k)
            if (side[k] != dvec2(0.0) && cross2(side[k], p - extreme[k]) <= 0.0) return false;
        return true;
    });
}

std::vector<dvec2> convexHull(std::vector<dvec2> points)
{
    dropInner(points);
    auto before = [](const dvec2& a, const dvec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
    std::sort(points.begin(), points.end(), before);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) return points;
    std::vector<dvec2> hull;
    auto add = [&](const dvec2& p, std::size_t keep) {
        while (hull.size() >= keep + 2 && cross2(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0) hull.pop_back();
        hull.push_back(p);
    };
    for (const dvec2& p : points) add(p, 0);
    std::size_t lower = hull.size() - 1; // the upper chain starts on the last point of the lower one
    for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
    hull.pop_back();
    return hull;
}

double signedArea(const dvec2* c) { return cross2(c[1] - c[0], c[2] - c[0]) / 2; }

dvec2 incentreOfLargest(const std::vector<dvec2>& corners)
{
    std::size_t largest = 0;
    for (std::size_t t = 0; t < corners.size(); t += 3)
        if (signedArea(&corners[t]) > signedArea(&corners[largest])) largest = t;
    const dvec2* c = &corners[largest];
    double a = distance(c[1], c[2]), b = distance(c[2], c[0]), d = distance(c[0], c[1]);
    return a + b + d > 0.0 ? (a * c[0] + b * c[1] + d * c[2]) / (a + b + d) : c[0];
}

void align(std::vector<dvec2>& corners, const std::vector<uint>& rim)
{
    dvec2 lower(1e300), upper(-1e300);
    double area = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) lower = min(lower, corners[i]), upper = max(upper, corners[i]);
    for (std::size_t t = 0; t < corners.size(); t += 3) area += signedArea(&corners[t]);
    dvec2 extent = upper - lower, scale(1.0);
    bool rectangular = area > kRectangular * extent.x * extent.y, point = max(extent.x, extent.y) < 0.5;
    for (int axis = 0; axis < 2; ++axis) {
        if (!(extent[axis] > 0.0)) continue;
        double texels = max(1.0, std::round(extent[axis]));
        if (point)
            scale[axis] = max(1.0, kSmallest / extent[axis]);
        else if (rectangular || extent[axis] < 1.0)
            scale[axis] = (texels + 2 * kOutset) / extent[axis];
    }
    for (dvec2& c : corners) c = (c - lower) * scale + 0.5 - kOutset;

    // A chart between the centres of the texels is moved onto one.
    if (coversTexel(corners, rim)) return;
    dvec2 centre = incentreOfLargest(corners);
    for (dvec2& c : corners) c += floor(centre) + 0.5 - centre;
}
}

dvec2 turnToSmallestRectangle(std::vector<dvec2>& corners)
{
    std::vector<dvec2> hull = convexHull(corners);
    double smallest = 1e300;
    dvec2 best(1.0, 0.0), size(0.0);
    for (std::size_t i = 0; i < hull.size(); ++i) {
        dvec2 side = hull[(i + 1) % hull.size()] - hull[i];
        if (length(side) == 0.0) continue;
        dvec2 x = normalize(side), lower(1e300), upper(-1e300);
        for (const dvec2& p : hull) {
            dvec2 q(dot(x, p), cross2(x, p));
            lower = min(lower, q), upper = max(upper, q);
        }
        dvec2 extent = upper - lower;
        if (extent.x * extent.y < smallest * (1 - 1e-9)) {
            smallest = extent.x * extent.y;
            size = {max(extent.x, extent.y), min(extent.x, extent.y)};
            best = extent.x >= extent.y ? x : dvec2(-x.y, x.x); // the quarter turn keeps orientation
        }
    }
    for (dvec2& p : corners) p = {dot(best, p), cross2(best, p)};
    return size;
}

std::vector<FlatChart> flatten(const Surface& surface, const Charts& charts, double texel)
{
    std::vector<FlatChart> result;
    std::vector<Triangles> todo(charts.charts.rbegin(), charts.charts.rend());
    std::vector<uint> chartOf(surface.triangles(), ~0u);
    uint tried = 0;
    while (!todo.empty()) {
        stopIfInterrupted();
        FlatChart chart{std::move(todo.back()), {}, {}, {}, {}};
        todo.pop_back();
        dvec3 axis = axisOf(surface, chart.triangles);
        chart.shape = project(surface, chart.triangles, axis);
        for (const uint t : chart.triangles) chartOf[t] = tried;
        ++tried;
        chart.rim = rimOf(chart.triangles, charts.neighbours, chartOf);
        const std::size_t count = chart.triangles.size(); // two that face the viewer lie on either side of what they share
        if (count > 1 &&
            (tooSteep(surface, chart.triangles, axis) || (count > 2 && foldsOver(chart.shape, chart.rim, kFoldSpacing * texel)))) {
            std::vector<Triangles> pieces = halve(chart.triangles, charts.neighbours);
            todo.insert(todo.end(), pieces.rbegin(), pieces.rend());
            continue;
        }
        turnToSmallestRectangle(chart.shape);
        result.push_back(std::move(chart));
    }
    return result;
}

bool setOnTexels(std::vector<FlatChart>& charts, const TexelOptions& options)
{
    for (FlatChart& chart : charts) {
        stopIfInterrupted();
        dvec2 lower(1e300), upper(-1e300);
        chart.corners = chart.shape;
        for (dvec2& c : chart.corners) {
            c *= options.texelsPerMetre;
            lower = min(lower, c), upper = max(upper, c);
        }
        if (max(upper.x - lower.x, upper.y - lower.y) + 2 * options.margin + 1 > options.largest) return false;
        align(chart.corners, chart.rim);
        ivec2 origin;
        chart.footprint = footprint(chart.corners, chart.rim, options.margin, origin);
        for (dvec2& c : chart.corners) c -= dvec2(origin);
    }
    return true;
}
}
