#include "baker/region.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace afterglow
{
static constexpr double kFar = std::numeric_limits<double>::infinity();

dvec3 Region::lower() const
{
    dvec3 least(kFar);
    for (const Face& face : faces)
        for (dvec3 corner : face.corners) least = min(least, corner);
    return least;
}

dvec3 Region::upper() const
{
    dvec3 most(-kFar);
    for (const Face& face : faces)
        for (dvec3 corner : face.corners) most = max(most, corner);
    return most;
}

double Region::volume() const
{
    double sum = 0.0; // of pyramids over the faces
    const dvec3 top = middle();
    for (const Face& face : faces) sum += area(face.corners) * (face.offset - dot(face.normal, top)) / 3.0;
    return sum;
}

bool Region::holds(dvec3 position) const
{
    return std::all_of(faces.begin(), faces.end(), [&](const Face& face) { return dot(face.normal, position) <= face.offset; });
}

Region boxRegion(dvec3 lower, dvec3 upper)
{
    Region region;
    for (int axis = 0; axis < 3; axis++)
        for (int side = 0; side < 2; side++) {
            Region::Face face{dvec3(0.0), 0.0, false, {}};
            face.normal[axis] = side ? 1.0 : -1.0;
            face.offset = side ? upper[axis] : -lower[axis];
            for (int k = 0; k < 4; k++) {
                dvec3 corner;
                corner[axis] = side ? upper[axis] : lower[axis];
                corner[(axis + 1) % 3] = k == 1 || k == 2 ? upper[(axis + 1) % 3] : lower[(axis + 1) % 3];
                corner[(axis + 2) % 3] = k >= 2 ? upper[(axis + 2) % 3] : lower[(axis + 2) % 3];
                face.corners.push_back(corner);
            }
            region.faces.push_back(face);
        }
    return region;
}

Polygon clipped(const Polygon& polygon, dvec3 normal, double offset)
{
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); i++) {
        const dvec3 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        const double ha = dot(normal, a) - offset, hb = dot(normal, b) - offset;
        if (ha <= 0.0) kept.push_back(a);
        if ((ha < 0.0 && hb > 0.0) || (ha > 0.0 && hb < 0.0)) kept.push_back(a + (b - a) * (ha / (ha - hb)));
    }
    if (kept.size() < 3) kept.clear();
    return kept;
}

Polygon within(const Region& region, Polygon polygon, double margin)
{
    for (const Region::Face& face : region.faces) {
        const double offset = face.offset - margin;
        const bool all = std::all_of(polygon.begin(), polygon.end(), [&](dvec3 corner) { return dot(face.normal, corner) <= offset; });
        if (!all) polygon = clipped(polygon, face.normal, offset);
        if (polygon.empty()) break;
    }
    return polygon;
}

double area(const Polygon& polygon)
{
    dvec3 sum(0.0);
    for (std::size_t i = 2; i < polygon.size(); i++) sum += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    return 0.5 * length(sum);
}

Polygon sectionOf(const Region& region, dvec3 normal, double offset)
{
    // A square about the region's middle, as large as all of it
    const dvec3 lower = region.lower(), upper = region.upper(), middle = 0.5 * (lower + upper);
    const double reach = 2.0 * length(upper - lower);
    const dvec3 foot = middle + normal * (offset - dot(normal, middle));
    const dvec3 aside = std::abs(normal.x) < 0.5 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
    const dvec3 u = reach * normalize(cross(normal, aside)), v = cross(normal, u);
    return within(region, {foot + u + v, foot - u + v, foot - u - v, foot + u - v}, 0.0);
}

Region clipped(const Region& region, dvec3 normal, double offset, bool wall, double thin)
{
    double nearest = kFar, farthest = -kFar;
    for (const Region::Face& face : region.faces)
        for (dvec3 corner : face.corners) {
            nearest = std::min(nearest, dot(normal, corner) - offset);
            farthest = std::max(farthest, dot(normal, corner) - offset);
        }
    if (!(nearest < -thin)) return {};
    if (farthest <= 0.0) return region;
    Region part;
    for (const Region::Face& face : region.faces) {
        Polygon corners = clipped(face.corners, normal, offset);
        if (!corners.empty()) part.faces.push_back({face.normal, face.offset, face.wall, std::move(corners)});
    }
    Polygon section = sectionOf(region, normal, offset);
    if (!section.empty()) part.faces.push_back({normal, offset, wall, std::move(section)});
    return part;
}
}
