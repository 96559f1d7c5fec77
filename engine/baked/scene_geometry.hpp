// A level's meshes, and their levels of detail, as glTF writes them.
#pragma once
#include "engine/baked/baked.hpp"
#include "engine/baked/glb.hpp"

namespace afterglow
{
// glTF meshes of the scene's: the mesh itself, then its coarser levels.
struct WrittenMesh {
    std::vector<std::size_t> meshes;    // indices into `meshes` of the file; empty: the mesh has no triangles
    std::vector<float> screenCoverages; // MSFT_screencoverage: the share of the picture down to which each of them is good enough
};

// Appends to `meshes` (a JSON array); `named` holds the original mesh's name and extras. Vertices are written in the order in which the
// indices first name them, which is the order in which import keeps them.
WrittenMesh writeMesh(const Baked& baked, std::size_t mesh, const nlohmann::json& named, std::size_t materialCount, BinaryChunk& chunk,
                      nlohmann::json& meshes);

// The way back: the coarser levels of a scene's mesh, from the meshes of the file that hold them. Throws Malformed.
MeshLods readLods(const Document& document, const Scene& scene, std::size_t mesh, const std::vector<std::size_t>& levels);

// Whether all of the levels say how far their normals turn; a bake of an earlier version says how far they stray alone.
bool sayTurns(const Document& document, const std::vector<std::size_t>& levels);
}
