// Where nodes put things: local transforms in double precision, and what makes one unusable (H19) or mirroring (H20).
#pragma once
#include "engine/scene/document.hpp"
#include "engine/scene/repair.hpp"
#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace afterglow
{
// The node's matrix, or its translation, rotation and scale.
dmat4 localTransform(const nlohmann::json& node);

// EXT_mesh_gpu_instancing: the transforms of the node's copies, relative to it; one identity when it has none.
std::vector<dmat4> copies(const Document& document, const nlohmann::json& node, std::size_t most);

// Finite, and its axes span space: neither flattened to a plane nor shrunk to a point.
bool invertible(const dmat4& toWorld);
bool mirrors(const dmat4& toWorld);

// The same triangles seen in a mirror at x = 0: positions, normals, tangents and winding agree with each other again.
const dmat4& reflection();
void reflect(std::vector<Vertex>& vertices, std::vector<uint>& indices);
}
