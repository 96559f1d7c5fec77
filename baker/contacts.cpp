#include "baker/contacts.hpp"
#include "engine/core/jobs.hpp"

namespace afterglow
{
static constexpr double kShortest = 4.0; // of `same`: shorter lines are points

dvec3 normalOf(const Corners& t)
{
    const dvec3 across = cross(t[1] - t[0], t[2] - t[0]);
    const double twiceArea = length(across);
    return twiceArea > 0.0 ? across / twiceArea : dvec3(0.0);
}

std::optional<Line> within(Line line, std::span<const dvec3> ring, const dvec3& normal, double same)
{
    for (std::size_t i = 0; i < ring.size(); i++) {
        const dvec3 side = ring[(i + 1) % ring.size()] - ring[i];
        if (!(length(side) > 0.0)) continue;
        const dvec3 inward = normalize(cross(normal, side));
        const double from = dot(line.from - ring[i], inward) + same, to = dot(line.to - ring[i], inward) + same;
        if (from < 0.0 && to < 0.0) return {};
        if (from < 0.0) line.from = mix(line.from, line.to, from / (from - to));
        if (to < 0.0) line.to = mix(line.to, line.from, to / (to - from));
    }
    if (!(distance(line.from, line.to) > kShortest * same)) return {};
    return line;
}

// The line that a triangle has in common with the plane of another, if part of it stands before that.
static std::optional<Line> inPlane(const Corners& triangle, const dvec3& origin, const dvec3& normal, double same)
{
    double height[3];
    dvec3 met[6];
    int points = 0;
    for (int i = 0; i < 3; i++) {
        height[i] = dot(triangle[std::size_t(i)] - origin, normal);
        if (abs(height[i]) <= same) height[i] = 0.0, met[points++] = triangle[std::size_t(i)];
    }
    if (!(max(max(height[0], height[1]), height[2]) > 0.0)) return {};
    for (std::size_t i = 0; i < 3; i++) {
        const double a = height[i], b = height[(i + 1) % 3];
        if (a * b < 0.0) met[points++] = mix(triangle[i], triangle[(i + 1) % 3], a / (a - b));
    }
    if (points != 2) return {};
    return Line{met[0], met[1]};
}

static bool shareEdge(const PlacedTriangle& a, const PlacedTriangle& b)
{
    if (a.object != b.object) return false;
    int shared = 0;
    for (const dvec3& p : a.corner)
        for (const dvec3& q : b.corner) shared += p == q ? 1 : 0;
    return shared >= 2;
}

std::vector<Lines> contactsOf(const std::vector<PlacedTriangle>& triangles, double same, int threads)
{
    std::vector<Corners> corners;
    for (const PlacedTriangle& t : triangles) corners.push_back(t.corner);
    const DistanceTree tree(corners);
    std::vector<Lines> contacts(triangles.size());
    parallelFor(triangles.size(), threads, [&](std::size_t i) {
        const Corners& here = corners[i];
        const dvec3 normal = normalOf(here);
        if (normal == dvec3(0.0)) return;
        tree.near(here, same, [&](uint other) {
            if (other == i || !triangles[other].opaque || shareEdge(triangles[i], triangles[other])) return;
            if (const std::optional<Line> line = inPlane(corners[other], here[0], normal, same))
                if (const std::optional<Line> part = within(*line, here, normal, same)) contacts[i].push_back(*part);
        });
    });
    return contacts;
}
}
