#include "engine/scene/geometry.hpp"
#include "engine/scene/accessor.hpp"
#include "engine/scene/fields.hpp"
#include "engine/scene/normals.hpp"
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

namespace afterglow
{
namespace
{
using nlohmann::json;

constexpr std::uint64_t kTriangles = 4, kTriangleStrip = 5, kTriangleFan = 6; // primitive modes
constexpr float kLargestUv = 1e6f; // beyond it a float holds less than a tenth of a turn of the texture

// Vertex attributes as the file holds them; an absent one has no values.
struct Attributes {
    std::vector<vec3> positions;
    Numbers normal, tangent, uv0, uv1, color;
};

Numbers attribute(const Document& document, const json& primitive, const char* name, int components, std::size_t vertices)
{
    const auto accessor = index(member(primitive, "attributes"), name, listOf(*document.json, "accessors").size());
    if (!accessor) return {};
    Numbers numbers = readNumbers(document, *accessor);
    if (numbers.components < components) throw Malformed(std::string(name) + " has too few components");
    if (vertices != 0 && numbers.count != vertices)
        throw Malformed(std::string(name) + " has " + std::to_string(numbers.count) + " elements for " + std::to_string(vertices) +
                        " vertices");
    return numbers;
}

Attributes readAttributes(const Document& document, const json& primitive, bool secondUv)
{
    Attributes all;
    const Numbers position = attribute(document, primitive, "POSITION", 3, 0);
    all.positions.resize(position.count);
    for (std::size_t i = 0; i < position.count; ++i)
        for (int c = 0; c < 3; ++c) all.positions[i][c] = position.values[i * position.components + c];
    all.normal = attribute(document, primitive, "NORMAL", 3, position.count);
    all.tangent = attribute(document, primitive, "TANGENT", 4, position.count);
    all.uv0 = attribute(document, primitive, secondUv ? "TEXCOORD_1" : "TEXCOORD_0", 2, position.count);
    all.uv1 = attribute(document, primitive, "TEXCOORD_1", 2, position.count);
    all.color = attribute(document, primitive, "COLOR_0", 3, position.count);
    return all;
}

// Three corners a triangle, whatever the mode.
std::vector<uint> readCorners(const Document& document, const json& primitive, std::size_t vertices)
{
    std::vector<uint> order;
    if (const auto accessor = index(primitive, "indices", listOf(*document.json, "accessors").size())) {
        order = readIndices(document, *accessor);
    } else {
        order.resize(vertices);
        std::iota(order.begin(), order.end(), 0u);
    }
    for (uint i : order)
        if (i >= vertices) throw Malformed("index " + std::to_string(i) + " points past its " + std::to_string(vertices) + " vertices");

    const std::uint64_t mode = size(primitive, "mode", kTriangles);
    if (mode == kTriangles) {
        if (order.size() % 3 != 0) throw Malformed("its " + std::to_string(order.size()) + " indices are not whole triangles");
        return order;
    }
    std::vector<uint> corners;
    for (std::size_t i = 0; i + 2 < order.size(); ++i) {
        const std::size_t turn = mode == kTriangleStrip ? i % 2 : 0; // every other triangle of a strip winds backwards
        const std::size_t first = mode == kTriangleFan ? 0 : i;
        corners.insert(corners.end(), {order[first], order[i + 1 + turn], order[i + 2 - turn]});
    }
    return corners;
}

vec2 uvAt(const Numbers& uv, std::size_t i, int& bad)
{
    if (uv.count == 0) return vec2(0.0f);
    const vec2 value(uv.values[i * uv.components], uv.values[i * uv.components + 1]);
    if (std::abs(value.x) <= kLargestUv && std::abs(value.y) <= kLargestUv) return value;
    ++bad;
    return vec2(0.0f);
}

uint colorAt(const Numbers& color, std::size_t i)
{
    vec4 value(1.0f);
    for (int c = 0; c < std::min(color.components, 4); ++c) value[c] = color.values[i * color.components + c];
    for (int c = 0; c < 4; ++c) value[c] = value[c] >= 0.0f ? std::min(value[c], 1.0f) : 0.0f; // NaN: 0
    return packUnorm4x8(value);
}

vec3 directionAt(const Numbers& numbers, std::size_t i)
{
    if (numbers.count == 0) return vec3(0.0f);
    return {numbers.values[i * numbers.components], numbers.values[i * numbers.components + 1], numbers.values[i * numbers.components + 2]};
}

// Without normals the triangles are flat (glTF), so they share no vertices; else only the vertices that are used are kept.
Triangles assemble(const Attributes& all, const std::vector<uint>& corners, Dropped& dropped)
{
    constexpr uint kUnseen = ~0u;
    Triangles triangles;
    std::vector<uint> place(all.positions.size(), kUnseen);
    int badUvs = 0;
    const bool flat = all.normal.count == 0;
    for (uint corner : corners) {
        if (flat || place[corner] == kUnseen) {
            place[corner] = uint(triangles.vertices.size());
            Vertex vertex{.position = all.positions[corner], .normal = directionAt(all.normal, corner)};
            const float hand = all.tangent.count != 0 ? all.tangent.values[corner * all.tangent.components + 3] : 0.0f;
            vertex.tangent = vec4(directionAt(all.tangent, corner), hand < 0.0f ? -1.0f : 1.0f);
            vertex.uv0 = uvAt(all.uv0, corner, badUvs);
            vertex.uv1 = uvAt(all.uv1, corner, badUvs);
            vertex.color = colorAt(all.color, corner);
            triangles.vertices.push_back(vertex);
        }
        triangles.indices.push_back(place[corner]);
    }
    if (badUvs > 0) dropped["texture coordinates that are no number"] += badUvs;
    return triangles;
}
}

Triangles readTriangles(const Document& document, const json& primitive, Reading reading, Dropped& dropped)
{
    const std::uint64_t mode = size(primitive, "mode", kTriangles);
    if (mode < kTriangles || mode > kTriangleFan) {
        ++dropped["primitives that are points or lines"];
        return {};
    }
    Attributes attributes = readAttributes(document, primitive, reading.secondUv);
    std::vector<uint> corners = readCorners(document, primitive, attributes.positions.size());
    dropBadTriangles(attributes.positions, corners, dropped);

    Triangles triangles = assemble(attributes, corners, dropped);
    const int badNormals = completeNormals(triangles.vertices, triangles.indices);
    if (badNormals > 0 && attributes.normal.count != 0) dropped["normals that are no direction"] += badNormals;
    if (attributes.tangent.count == 0 && attributes.uv0.count != 0 && reading.tangents)
        computeTangents(triangles.vertices, triangles.indices);
    const int badTangents = completeTangents(triangles.vertices);
    if (badTangents > 0 && attributes.tangent.count != 0) dropped["tangents that are no direction"] += badTangents;
    return triangles;
}
}
