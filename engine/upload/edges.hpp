// The edges that may be lines of a drawing, found on the meshes themselves: vertices at one place are one vertex, so that no seam of uv or
// normals is an edge, whatever the file had to split there.
#pragma once
#include "engine/upload/gpu_scene.hpp"
#include "shaders/edge.h"

namespace afterglow
{
// Of all primitives of a mesh together. Cut-out surfaces have none: their shape is in a texture. creaseAngle: radians.
std::vector<MeshEdge> meshEdges(const Scene& scene, const Mesh& mesh, float creaseAngle);

// One placed mesh: a range of the edges, and of what is drawn of it, which knows where it stands.
struct EdgeDraw {
    uint first = 0, count = 0;
    std::size_t firstItem = 0, itemCount = 0; // of GpuScene::draws
};

struct GpuEdges {
    GpuBuffer edges; // MeshEdge; absent when there is none
    std::vector<EdgeDraw> draws;
};
GpuEdges uploadEdges(Gpu& gpu, const Scene& scene, const std::vector<DrawItem>& items, float creaseAngle);
}
