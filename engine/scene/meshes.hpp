// The level's meshes: each is read from the file when a node first places it, so what nothing places costs nothing.
#pragma once
#include "engine/scene/bounds.hpp"
#include "engine/scene/document.hpp"
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>

namespace afterglow
{
struct Meshes {
    const Document& document;
    Scene& scene;                                      // holds what was read
    std::vector<bool> secondUv;                        // by material: readMaterials() says
    std::map<std::pair<std::size_t, bool>, uint> read; // (index in the file, mirrored) -> index in the level
};

// The mesh's index in the level. A mirrored one is a copy, reflected (placement.hpp). Throws Malformed naming mesh and primitive.
uint meshOf(Meshes& meshes, std::size_t index, bool mirrored);

// The world box of a placed mesh of the level.
Box boundsOf(const Scene& scene, const Mesh& mesh, const dmat4& toWorld);

// Three corners a triangle, in the world, of a mesh of the file that is read for this question only.
std::vector<dvec3> trianglesOf(const Document& document, std::size_t index, const dmat4& toWorld, Dropped& dropped);

// `mesh "Wall"`, or by number when it has no name.
std::string label(const nlohmann::json& thing, const char* kind, std::size_t index);
}
