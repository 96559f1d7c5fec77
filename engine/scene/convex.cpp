// Every side is the plane of a triangle, turned away from the middle; a convex body lies behind all of them. A closed surface has no net
// area: the sum of its sides' normals, each as long as its area, is 0 (Minkowski), which an open one is not.
#include "engine/scene/convex.hpp"
#include "engine/scene/bounds.hpp"

namespace afterglow
{
namespace
{
// Positions are floats in the file: of the body's diagonal, what a corner may stand before a plane it belongs to.
constexpr double kTolerance = 1e-5;

bool isAxis(const dvec3& normal) { return std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)}) > 1.0 - 1e-10; }

double before(const dvec4& plane, const dvec3& point) { return dot(dvec3(plane), point) - plane.w; }
}

std::optional<std::vector<dvec4>> convexPlanes(const std::vector<dvec3>& corners)
{
    Box box;
    for (const dvec3& corner : corners) grow(box, corner);
    if (box.empty()) return std::nullopt;
    dvec3 middle(0.0); // of all corners: inside of a convex body, where the middle of its box need not be
    for (const dvec3& corner : corners) middle += corner / double(corners.size());
    const double tolerance = kTolerance * length(box.upper - box.lower);

    std::vector<dvec4> planes;
    dvec3 netArea(0.0);
    double area = 0.0;
    bool box_ = true;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        dvec3 normal = cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]);
        const double twice = length(normal);
        if (!(twice > tolerance * tolerance)) continue; // a sliver turns nowhere
        normal /= twice;
        if (dot(normal, corners[i] - middle) < 0.0) normal = -normal;
        netArea += twice * normal;
        area += twice;
        const dvec4 plane(normal, dot(normal, corners[i]));
        const auto known = std::find_if(planes.begin(), planes.end(), [&](const dvec4& other) {
            if (dot(dvec3(other), normal) < 0.0) return false;
            return std::abs(before(other, corners[i])) < tolerance && std::abs(before(other, corners[i + 1])) < tolerance &&
                   std::abs(before(other, corners[i + 2])) < tolerance;
        });
        if (known != planes.end()) continue;
        if (planes.size() == kMostPlanes) return std::nullopt;
        planes.push_back(plane);
        box_ = box_ && isAxis(normal);
    }
    if (planes.size() < 4 || !(length(netArea) <= kTolerance * area)) return std::nullopt;
    for (const dvec3& corner : corners)
        for (const dvec4& plane : planes)
            if (before(plane, corner) > tolerance) return std::nullopt;
    if (box_) planes.clear();
    return planes;
}
}
