// Where the surfaces of a level meet: on each triangle, the lines along which others stand on it or pass through it. Light differs from one
// side of such a line to the other.
#pragma once
#include "baker/distance.hpp"
#include <optional>

namespace afterglow
{
struct Line {
    dvec3 from, to;
};
using Lines = std::vector<Line>;

struct PlacedTriangle {
    Corners corner; // world, m
    uint object;
    bool opaque;
};

// Of each triangle, in its plane. Nearer than `same` (m) is touching. What only hangs below a triangle's front is no matter, nor is a
// neighbour across an edge of the same object.
std::vector<Lines> contactsOf(const std::vector<PlacedTriangle>& triangles, double same, int threads);

// The part of a line in a convex ring of its plane, whose unit normal sees it counterclockwise; none when it is no longer than a few
// `same`.
std::optional<Line> within(Line line, std::span<const dvec3> ring, const dvec3& normal, double same);

// Unit; 0 when the triangle has no area.
dvec3 normalOf(const Corners& triangle);
}
