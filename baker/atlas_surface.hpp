// A mesh as the atlas sees it: the triangles of all its primitives, in metres as placed in the world (but for the translation).
#pragma once
#include "engine/scene/scene.hpp"

namespace afterglow
{
struct Surface {
    std::vector<vec3> keys;     // per vertex: position as the level stores it; equal keys are one point
    std::vector<dvec3> points;  // per vertex, m
    std::vector<uint> indices;  // three per triangle
    std::vector<double> areas;  // per triangle, m2
    std::vector<dvec3> normals; // per triangle, unit; 0 when degenerate
    std::vector<uint> pieces;   // per triangle

    std::size_t triangles() const { return indices.size() / 3; }
    const dvec3& point(uint triangle, int corner) const { return points[indices[3 * triangle + uint(corner)]]; }
};

// Of one piece. Vertices and triangles in the order of the mesh's primitives.
Surface surfaceOf(const Scene& scene, const Mesh& mesh, const dmat3& toWorld);
}
