// The nodes of a baked level: where its objects stand, which part of which lightmap page is theirs, which coarser meshes stand in for them.
#pragma once
#include "engine/baked/scene_geometry.hpp"

namespace afterglow
{
// Rewrites the nodes of the level's JSON so that each object of the scene is one node with its mesh. The hierarchy, names and extras stay.
// A node that carries its one object and nothing else keeps it; others get a child per object (instanced and mirrored meshes, and nodes
// with children, light or camera whose mesh has levels of detail: MSFT_lod swaps whole nodes).
// In a node's extras, ag_lightmap is {"page", "scale", "offset"}: page uv = TEXCOORD_1 * scale + offset, v downwards.
void writeNodes(const Baked& baked, const std::vector<WrittenMesh>& meshes, nlohmann::json& json);

// The way back, for the scene that was loaded from this document: places and levels of detail. Throws Malformed.
void readNodes(const Document& document, Baked& baked);
}
