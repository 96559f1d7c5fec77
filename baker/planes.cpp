#include "baker/planes.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace afterglow
{
using Key = std::array<long long, 4>; // of a plane, to the thousandth of a normal's length and to the region's thinness

// What a triangle tells of its plane.
struct Told {
    Key key;
    Plane plane;
};

static Key keyOf(dvec3 normal, double offset, double thin)
{
    return {std::llround(normal.x * 1e3), std::llround(normal.y * 1e3), std::llround(normal.z * 1e3), std::llround(offset / thin)};
}

// m, from a point within to the nearest of a region's faces; negative: it is not within.
static double clearanceOf(const Region& region, dvec3 point)
{
    double least = std::numeric_limits<double>::infinity();
    for (const Region::Face& face : region.faces) least = std::min(least, face.offset - dot(face.normal, point));
    return least;
}

namespace
{
// What of a triangle lies within a region.
struct Inside {
    double area = 0.0; // m2
    dvec3 middle{0.0};
};
}

static Inside insideOf(const Region& region, double thin, const dvec3 (&corner)[3])
{
    const dvec3 across = cross(corner[1] - corner[0], corner[2] - corner[0]);
    const bool whole = std::all_of(corner, corner + 3, [&](dvec3 c) { return clearanceOf(region, c) >= thin; }); // most of a dense mesh
    if (whole) return {0.5 * length(across), (corner[0] + corner[1] + corner[2]) / 3.0};
    const Polygon polygon = within(region, {corner[0], corner[1], corner[2]}, thin);
    Inside inside{area(polygon)};
    for (dvec3 c : polygon) inside.middle += c / double(polygon.size());
    return inside;
}

// False: the triangle does not reach into the region.
static bool tellOf(const World& world, const Region& region, dvec3 lower, dvec3 upper, double thin, uint triangle, Told& told)
{
    dvec3 corner[3];
    for (int i = 0; i < 3; i++) corner[i] = dvec3(world.vertices()[world.triangles()[triangle].vertex[i]].position);
    if (any(lessThan(max(max(corner[0], corner[1]), corner[2]), lower)) ||
        any(greaterThan(min(min(corner[0], corner[1]), corner[2]), upper)))
        return false;
    dvec3 normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
    if (!(dot(normal, normal) > 0.0)) return false;
    const Inside inside = insideOf(region, thin, corner);
    if (!(inside.area > 0.0)) return false;
    normal = normalize(normal);
    const dvec3 size = abs(normal);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    if (normal[axis] < 0.0) normal = -normal;
    const double offset = dot(normal, corner[0]);
    // In a convex region a plane through a point cuts at least the disc about it that no face reaches into
    const double clearance = std::max(clearanceOf(region, inside.middle), 0.0);
    told = {keyOf(normal, offset, thin), {normal, offset, inside.area, 3.14 * clearance * clearance}};
    return true;
}

std::vector<Plane> planesIn(const World& world, const Region& region, double thin, std::vector<uint>& triangles)
{
    const dvec3 lower = region.lower() + thin, upper = region.upper() - thin;
    std::vector<Told> all;
    std::size_t kept = 0;
    for (uint triangle : triangles) {
        Told told;
        if (!tellOf(world, region, lower, upper, thin, triangle, told)) continue;
        all.push_back(told);
        triangles[kept++] = triangle;
    }
    triangles.resize(kept);
    std::stable_sort(all.begin(), all.end(), [](const Told& a, const Told& b) { return a.key < b.key; });
    std::vector<Plane> planes;
    for (std::size_t i = 0; i < all.size(); i++) {
        if (i == 0 || all[i].key != all[i - 1].key) {
            planes.push_back(all[i].plane);
            continue;
        }
        planes.back().area += all[i].plane.area;
        planes.back().leastSection = std::max(planes.back().leastSection, all[i].plane.leastSection);
    }
    return planes;
}
}
