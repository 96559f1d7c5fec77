#include "engine/scene/meshes.hpp"
#include "engine/scene/fields.hpp"
#include "engine/scene/geometry.hpp"
#include "engine/scene/material.hpp"
#include "engine/scene/placement.hpp"
#include <nlohmann/json.hpp>

namespace afterglow
{
namespace
{
using nlohmann::json;

constexpr std::size_t kMostElements = std::size_t(1) << 28; // of vertices, of indices: 19 GB of vertices

// The material's index in the level; plaster where the file names none.
uint materialOf(const Meshes& meshes, const json& primitive)
{
    Scene& scene = meshes.scene;
    const std::size_t count = listOf(*meshes.document.json, "materials").size();
    if (const auto material = index(primitive, "material", count)) return uint(*material);
    if (scene.materials.size() == count) {
        scene.materials.push_back(plaster());
        scene.materialNames.push_back("plaster");
        scene.warnings.push_back("some primitives have no material and are shown as grey plaster");
    }
    return uint(count);
}

Reading readingOf(const Meshes& meshes, uint material)
{
    const Material& m = meshes.scene.materials[material];
    return {.tangents = m.normalTexture.texture >= 0 || m.anisotropy > 0.0f,
            .secondUv = material < meshes.secondUv.size() && meshes.secondUv[material]};
}

void append(Scene& scene, Mesh& mesh, const Triangles& triangles, uint material)
{
    if (triangles.indices.empty()) return;
    if (triangles.vertices.size() > kMostElements - scene.vertices.size() ||
        triangles.indices.size() > kMostElements - scene.indices.size())
        throw Malformed("the level has more than " + std::to_string(kMostElements) + " vertices or indices, the most that is read");
    mesh.primitives.push_back({uint(scene.vertices.size()), uint(triangles.vertices.size()), uint(scene.indices.size()),
                               uint(triangles.indices.size()), material});
    scene.vertices.insert(scene.vertices.end(), triangles.vertices.begin(), triangles.vertices.end());
    scene.indices.insert(scene.indices.end(), triangles.indices.begin(), triangles.indices.end());
}

// Calls use(primitive) for each primitive of a mesh of the file; a problem is told with its place.
template <typename Use>
void forPrimitives(const Document& document, std::size_t i, const Use& use)
{
    const json& mesh = listOf(*document.json, "meshes")[i];
    const json& primitives = listOf(mesh, "primitives");
    for (std::size_t p = 0; p < primitives.size(); ++p) {
        try {
            use(primitives[p]);
        } catch (const Malformed& problem) {
            throw Malformed(label(mesh, "mesh", i) + ", primitive " + std::to_string(p) + ": " + problem.what());
        }
    }
}
}

std::string label(const json& thing, const char* kind, std::size_t index)
{
    const std::string name = text(thing, "name");
    return std::string(kind) + " " + (name.empty() ? std::to_string(index) : "\"" + name + "\"");
}

uint meshOf(Meshes& meshes, std::size_t index, bool mirrored)
{
    Scene& scene = meshes.scene;
    const auto [place, isNew] = meshes.read.try_emplace({index, mirrored}, uint(scene.meshes.size()));
    if (!isNew) return place->second;

    Dropped again; // what the other hand's reading has counted already
    Dropped& dropped = meshes.read.contains({index, !mirrored}) ? again : scene.dropped;
    Mesh mesh{text(listOf(*meshes.document.json, "meshes")[index], "name", "mesh " + std::to_string(index)), {}};
    forPrimitives(meshes.document, index, [&](const json& primitive) {
        const uint material = materialOf(meshes, primitive);
        Triangles triangles = readTriangles(meshes.document, primitive, readingOf(meshes, material), dropped);
        if (mirrored) reflect(triangles.vertices, triangles.indices);
        append(scene, mesh, triangles, material);
    });
    scene.meshes.push_back(std::move(mesh));
    return place->second;
}

Box boundsOf(const Scene& scene, const Mesh& mesh, const dmat4& toWorld)
{
    Box box;
    for (const Primitive& primitive : mesh.primitives)
        for (uint v = 0; v < primitive.vertexCount; ++v)
            grow(box, dvec3(toWorld * dvec4(dvec3(scene.vertices[primitive.firstVertex + v].position), 1.0)));
    return box;
}

std::vector<dvec3> trianglesOf(const Document& document, std::size_t index, const dmat4& toWorld, Dropped& dropped)
{
    std::vector<dvec3> corners;
    forPrimitives(document, index, [&](const json& primitive) {
        const Triangles triangles = readTriangles(document, primitive, {}, dropped);
        for (const uint i : triangles.indices) corners.push_back(dvec3(toWorld * dvec4(dvec3(triangles.vertices[i].position), 1.0)));
    });
    return corners;
}
}
