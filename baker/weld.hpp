// Which vertices of a triangle list are one point, and which corners may be one vertex of a half-edge mesh.
// A level's vertices are split at seams of uv and normal, and its surfaces meet in edges of three faces, in bow ties, in flipped and
// doubled faces; a half-edge mesh refuses all of these. Here the sheets are parted first, so that no face is lost: area in is area out.
#pragma once
#include "shaders/glsl.h"
#include <span>
#include <vector>

namespace afterglow
{
using namespace shared;

constexpr uint kNoCorner = ~0u;

inline uint nextCorner(uint corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; } // of its triangle

struct Weld {
    std::vector<uint> point;         // per input vertex: id of its position; -0 is 0
    std::vector<uint> vertex;        // per corner, three to a triangle: id of its vertex in the manifold mesh
    std::vector<uint> pointOfVertex; // per manifold vertex
    std::vector<uint> across; // per corner: where the other triangle's side starts that continues the one that starts here; kNoCorner
    uint points = 0;
    int partedEdges = 0; // edges of three or more faces, or of two that disagree in winding, where a sheet had to end
};

Weld weld(std::span<const vec3> positions, std::span<const uint> indices);
}
