// A glTF primitive as triangles: its topology unrolled, its attributes decoded, what is broken dropped, what is missing computed.
#pragma once
#include "engine/scene/document.hpp"
#include "engine/scene/repair.hpp"
#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace afterglow
{
// Indices are relative to these vertices; each vertex is used. Empty when nothing of the primitive can be drawn.
struct Triangles {
    std::vector<Vertex> vertices;
    std::vector<uint> indices;
};

// What the primitive's material reads of it.
struct Reading {
    bool tangents = false; // along the texture: for a normal map or anisotropy; else any
    bool secondUv = false; // its textures by TEXCOORD_1, which becomes uv0: the baker's atlas takes uv1
};

// Throws Malformed: `index 17 points past its 12 vertices`; the caller says which primitive.
Triangles readTriangles(const Document& document, const nlohmann::json& primitive, Reading reading, Dropped& dropped);
}
