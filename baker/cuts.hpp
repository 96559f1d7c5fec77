// Cuts the triangles of a mesh along lines, so that no triangle lies on both sides of one. Sides that triangles share stay shared: where
// one gets a point, its neighbours get it too.
#pragma once
#include "baker/contacts.hpp"
#include <set>

namespace afterglow
{
using Side = std::pair<uint, uint>; // of a triangle: two points, the lower first
inline Side sideOf(uint a, uint b) { return {min(a, b), max(a, b)}; }

struct CutMesh {
    struct Triangle {
        uint point[3];
        uint parent; // of which it is a part
    };
    std::vector<dvec3> points;
    std::vector<Triangle> triangles; // by parent, ascending
    std::set<Side> onLines;          // sides that lie on a line
};

bool isOn(const Line& line, const dvec3& point, double same);

// `lines` has those of each triangle, in its plane; points nearer than `same` are one.
CutMesh cutAlong(std::span<const Corners> triangles, std::span<const Lines> lines, double same);
}
