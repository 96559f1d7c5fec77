#include "engine/baked/scene_geometry.hpp"
#include "engine/core/error.hpp"
#include "engine/scene/accessor.hpp"
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

constexpr uint kUnseen = ~0u;

namespace
{
// A primitive's vertices in the order of first use, and where each went.
struct Order {
    std::vector<uint> vertices, place;
};
}

static Order orderOf(const Scene& scene, const Primitive& primitive)
{
    Order order{{}, std::vector<uint>(primitive.vertexCount, kUnseen)};
    for (uint i = 0; i < primitive.indexCount; ++i) {
        const uint vertex = scene.indices[primitive.firstIndex + i];
        if (order.place[vertex] != kUnseen) continue;
        order.place[vertex] = uint(order.vertices.size());
        order.vertices.push_back(vertex);
    }
    return order;
}

// One attribute of the ordered vertices: write(bytes, vertex) puts the numbers of one.
template <class Write>
static std::size_t addAttribute(const Scene& scene, const Primitive& primitive, const Order& order, AccessorShape shape, BinaryChunk& chunk,
                                Write write)
{
    Bytes bytes;
    for (uint vertex : order.vertices) write(bytes, scene.vertices[primitive.firstVertex + vertex]);
    shape.count = order.vertices.size();
    return addAccessor(chunk, bytes, shape, ViewTarget::vertices);
}

static void putNumbers(Bytes& bytes, const float* numbers, int count)
{
    for (int i = 0; i < count; ++i) putFloat(bytes, numbers[i]);
}

// Positions must say their bounds.
static void addBounds(json& accessor, const Scene& scene, const Primitive& primitive, const Order& order)
{
    vec3 lower(kFloatMax), upper(-kFloatMax);
    for (uint vertex : order.vertices) {
        lower = min(lower, scene.vertices[primitive.firstVertex + vertex].position);
        upper = max(upper, scene.vertices[primitive.firstVertex + vertex].position);
    }
    accessor["min"] = {lower.x, lower.y, lower.z};
    accessor["max"] = {upper.x, upper.y, upper.z};
}

static json writeAttributes(const Scene& scene, const Primitive& primitive, const Order& order, bool lightmapped, BinaryChunk& chunk)
{
    const auto any = [&](auto holds) {
        return std::any_of(order.vertices.begin(), order.vertices.end(),
                           [&](uint v) { return holds(scene.vertices[primitive.firstVertex + v]); });
    };
    const auto add = [&](const char* type, auto write) {
        return addAttribute(scene, primitive, order, {.component = Component::f32, .type = type}, chunk, write);
    };
    json attributes;
    attributes["POSITION"] = add("VEC3", [](Bytes& bytes, const Vertex& v) { putNumbers(bytes, &v.position.x, 3); });
    addBounds(chunk.accessors->back(), scene, primitive, order);
    attributes["NORMAL"] = add("VEC3", [](Bytes& bytes, const Vertex& v) { putNumbers(bytes, &v.normal.x, 3); });

    const Material& material = scene.materials[primitive.material];
    if (material.normalTexture.texture >= 0 || material.anisotropy > 0.0f) // nobody else reads tangents
        attributes["TANGENT"] = add("VEC4", [](Bytes& bytes, const Vertex& v) { putNumbers(bytes, &v.tangent.x, 4); });
    const bool second = lightmapped || any([](const Vertex& v) { return v.uv1 != vec2(0.0f); });
    if (second || any([](const Vertex& v) { return v.uv0 != vec2(0.0f); }))
        attributes["TEXCOORD_0"] = add("VEC2", [](Bytes& bytes, const Vertex& v) { putNumbers(bytes, &v.uv0.x, 2); });
    if (second) attributes["TEXCOORD_1"] = add("VEC2", [](Bytes& bytes, const Vertex& v) { putNumbers(bytes, &v.uv1.x, 2); });
    if (any([](const Vertex& v) { return v.color != 0xFFFFFFFFu; })) {
        const AccessorShape shape{.component = Component::u8, .type = "VEC4", .normalized = true};
        attributes["COLOR_0"] =
            addAttribute(scene, primitive, order, shape, chunk, [](Bytes& bytes, const Vertex& v) { put32(bytes, v.color); });
    }
    return attributes;
}

static std::size_t writeIndices(std::span<const uint> indices, const Order& order, BinaryChunk& chunk)
{
    const bool isShort = order.vertices.size() < 0xFFFF; // the largest number means restart
    Bytes bytes;
    for (uint index : indices) {
        check(index < order.place.size() && order.place[index] != kUnseen, "a level of detail keeps a subset of its primitive's vertices");
        if (isShort)
            put<std::uint16_t>(bytes, order.place[index]);
        else
            put32(bytes, order.place[index]);
    }
    return addAccessor(chunk, bytes, {.component = isShort ? Component::u16 : Component::u32, .count = indices.size()},
                       ViewTarget::indices);
}

// A level is good enough while its error stays below a pixel of a picture 1080 pixels high. An object of diagonal d whose image is s of
// the picture's height shows an error e as e / d * s * 1080 pixels: s = d / (1080 e), and of the picture's area about s^2.
static float coverage(float diagonal, float error)
{
    const float share = error > 0.0f ? std::min(diagonal / (1080.0f * error), 1.0f) : 1.0f;
    return share * share;
}

static float diagonalOf(const Scene& scene, const Mesh& mesh)
{
    vec3 lower(kFloatMax), upper(-kFloatMax);
    for (const Primitive& primitive : mesh.primitives) {
        for (uint v = 0; v < primitive.vertexCount; ++v) {
            lower = min(lower, scene.vertices[primitive.firstVertex + v].position);
            upper = max(upper, scene.vertices[primitive.firstVertex + v].position);
        }
    }
    return length(upper - lower);
}

WrittenMesh writeMesh(const Baked& baked, std::size_t index, const json& named, std::size_t materialCount, BinaryChunk& chunk, json& meshes)
{
    const Scene& scene = baked.scene;
    const Mesh& mesh = scene.meshes[index];
    WrittenMesh written;
    if (mesh.primitives.empty()) return written;

    bool lightmapped = false;
    for (std::size_t o = 0; o < scene.objects.size() && o < baked.places.size(); ++o)
        lightmapped = lightmapped || (scene.objects[o].mesh == index && baked.places[o].page >= 0);

    std::vector<Order> orders;
    json finest = named;
    finest["primitives"] = json::array();
    for (const Primitive& primitive : mesh.primitives) {
        const Order& order = orders.emplace_back(orderOf(scene, primitive));
        json& made = finest["primitives"].emplace_back();
        made["attributes"] = writeAttributes(scene, primitive, order, lightmapped, chunk);
        made["indices"] = writeIndices({&scene.indices[primitive.firstIndex], primitive.indexCount}, order, chunk);
        if (primitive.material < materialCount) made["material"] = primitive.material; // else plaster, which the file calls nothing
    }
    meshes.push_back(finest);
    written.meshes.push_back(meshes.size() - 1);

    // Coarser levels share the vertices; a primitive that has run out of levels keeps its coarsest.
    std::size_t levels = 0;
    const MeshLods none, &lods = index < baked.lods.size() ? baked.lods[index] : none;
    for (const auto& primitive : lods.primitives) levels = std::max(levels, primitive.size());
    const float diagonal = diagonalOf(scene, mesh);
    json coarser = finest;
    coarser.erase("extras");
    for (std::size_t level = 0; level < levels; ++level) {
        float error = 0.0f;
        if (named.contains("name")) coarser["name"] = named["name"].get<std::string>() + " lod " + std::to_string(level + 1);
        for (std::size_t p = 0; p < lods.primitives.size(); ++p) {
            json& made = coarser["primitives"][p];
            made.erase("extras");
            if (level >= lods.primitives[p].size()) continue;
            const LodLevel& lod = lods.primitives[p][level];
            made["indices"] = writeIndices(lod.indices, orders[p], chunk);
            // m of object space, and radians; absent: not a level of this primitive
            made["extras"] = {{"ag_lod_error", lod.error}, {"ag_lod_turn", lod.turn}};
            error = std::max(error, lod.error);
        }
        meshes.push_back(coarser);
        written.meshes.push_back(meshes.size() - 1);
        written.screenCoverages.push_back(coverage(diagonal, error));
    }
    written.screenCoverages.push_back(0.0f); // the coarsest is good to the end
    return written;
}

bool sayTurns(const Document& document, const std::vector<std::size_t>& levels)
{
    for (const std::size_t level : levels)
        for (const json& primitive : document.json->at("meshes").at(level).at("primitives"))
            if (primitive.contains("extras") && !primitive["extras"].contains("ag_lod_turn")) return false;
    return true;
}

MeshLods readLods(const Document& document, const Scene& scene, std::size_t index, const std::vector<std::size_t>& levels)
{
    const Mesh& mesh = scene.meshes[index];
    MeshLods lods;
    lods.primitives.resize(mesh.primitives.size());
    for (std::size_t level : levels) {
        const json& primitives = document.json->at("meshes").at(level).at("primitives");
        if (primitives.size() != mesh.primitives.size()) throw Malformed("a level of detail has other primitives than its mesh");
        for (std::size_t p = 0; p < primitives.size(); ++p) {
            if (!primitives[p].contains("extras")) continue;
            LodLevel lod;
            lod.error = primitives[p]["extras"].at("ag_lod_error").get<float>();
            lod.turn = primitives[p]["extras"].value("ag_lod_turn", kPi); // what does not say is not drawn
            lod.indices = readIndices(document, primitives[p].at("indices").get<std::size_t>());
            for (uint vertex : lod.indices)
                if (vertex >= mesh.primitives[p].vertexCount) throw Malformed("a level of detail names a vertex that is not there");
            if (lod.indices.size() % 3 != 0 || !(lod.error >= 0.0f && std::isfinite(lod.error)) || !(lod.turn >= 0.0f && lod.turn <= kPi))
                throw Malformed("a level of detail is damaged");
            lods.primitives[p].push_back(std::move(lod));
        }
    }
    return lods;
}
}
