#include "baker/planes.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace afterglow
{
using Key = std::array<long long, 4>; // of a plane, to the thousandth of a normal's length and to the region's thinness

// Of a triangle that reaches into a region.
struct Told {
    Key key;
    uint triangle;
    dvec3 normal, middle; // of what lies within
    double offset, area, clearance;

    // m2. A convex region holds the ball about a point within that no face reaches into: planes cut it at least in that ball's section.
    double sectionBy(const Plane& plane) const
    {
        const double away = dot(plane.normal, middle) - plane.offset;
        return 0.999 * double(kPi) * std::max(clearance * clearance - away * away, 0.0); // a float's pi is a little more
    }
};

static Key keyOf(dvec3 normal, double offset, double thin)
{
    return {std::llround(normal.x * 1e3), std::llround(normal.y * 1e3), std::llround(normal.z * 1e3), std::llround(offset / thin)};
}

using Corners = std::array<dvec3, 3>;
static Corners cornersOf(const World& world, uint triangle)
{
    Corners corners;
    for (std::size_t i = 0; i < 3; i++) corners[i] = dvec3(world.vertices()[world.triangles()[triangle].vertex[i]].position);
    return corners;
}

static bool isBeside(const Corners& corner, dvec3 lower, dvec3 upper)
{
    return any(lessThan(max(max(corner[0], corner[1]), corner[2]), lower)) ||
           any(greaterThan(min(min(corner[0], corner[1]), corner[2]), upper));
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

static Inside insideOf(const Region& region, double thin, const Corners& corner)
{
    const dvec3 across = cross(corner[1] - corner[0], corner[2] - corner[0]);
    const bool whole =
        std::all_of(corner.begin(), corner.end(), [&](dvec3 c) { return clearanceOf(region, c) >= thin; }); // most of a dense mesh
    if (whole) return {0.5 * length(across), (corner[0] + corner[1] + corner[2]) / 3.0};
    const Polygon polygon = within(region, {corner[0], corner[1], corner[2]}, thin);
    Inside inside{area(polygon)};
    for (dvec3 c : polygon) inside.middle += c / double(polygon.size());
    return inside;
}

// Nothing: the triangle does not reach into the region, or has no area.
static std::optional<Told> toldBy(const Region& region, double thin, uint triangle, const Corners& corner)
{
    dvec3 normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
    if (!(dot(normal, normal) > 0.0)) return {};
    const Inside inside = insideOf(region, thin, corner);
    if (!(inside.area > 0.0)) return {};
    normal = normalize(normal);
    const dvec3 size = abs(normal);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    if (normal[axis] < 0.0) normal = -normal;
    const double offset = dot(normal, corner[0]), clearance = std::max(clearanceOf(region, inside.middle), 0.0);
    return Told{keyOf(normal, offset, thin), triangle, normal, inside.middle, offset, inside.area, clearance};
}

std::vector<Plane> planesIn(const World& world, const Region& region, double thin, std::vector<uint>& triangles)
{
    const dvec3 lower = region.lower() + thin, upper = region.upper() - thin;
    std::vector<Told> all;
    all.reserve(triangles.size());
    std::erase_if(triangles, [&](uint triangle) {
        const Corners corner = cornersOf(world, triangle);
        if (isBeside(corner, lower, upper)) return true;
        const std::optional<Told> told = toldBy(region, thin, triangle, corner);
        if (told) all.push_back(*told);
        return !told;
    });
    std::sort(all.begin(), all.end(),
              [](const Told& a, const Told& b) { return std::tie(a.key, a.triangle) < std::tie(b.key, b.triangle); });
    std::vector<Plane> planes;
    for (std::size_t i = 0; i < all.size(); i++) {
        if (i == 0 || all[i].key != all[i - 1].key) planes.push_back({all[i].normal, all[i].offset});
        Plane& plane = planes.back();
        plane.area += all[i].area;
        plane.leastSection = std::max(plane.leastSection, all[i].sectionBy(plane));
    }
    return planes;
}
}
