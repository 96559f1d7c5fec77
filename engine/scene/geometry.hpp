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

enum class Tangents { arbitrary, followTexture }; // followTexture: a normal map or anisotropy reads them

// Throws Malformed: `index 17 points past its 12 vertices`; the caller says which primitive.
Triangles readTriangles(const Document& document, const nlohmann::json& primitive, Tangents tangents, Dropped& dropped);
}
