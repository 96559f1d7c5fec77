// Reads a level: materials, then the nodes of its scene from the roots, each placing what it holds.
#include "engine/core/error.hpp"
#include "engine/scene/extras.hpp"
#include "engine/scene/fields.hpp"
#include "engine/scene/geometry.hpp"
#include "engine/scene/lens.hpp"
#include "engine/scene/light.hpp"
#include "engine/scene/material.hpp"
#include "engine/scene/placement.hpp"
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

namespace afterglow
{
namespace
{
using nlohmann::json;

constexpr std::size_t kMostInstances = 16777215;     // 24 bits: what an acceleration structure can number
constexpr std::size_t kMostElements = 0xFFFFFFFEull; // of vertices, of indices: 32 bits number them
constexpr double kSmallestSize = 1e-15;              // m: below, the area of a triangle squared is no float

struct Box {
    dvec3 lower{std::numeric_limits<double>::infinity()}, upper{-std::numeric_limits<double>::infinity()};
};

// What the walk carries from node to node.
struct Walk {
    const Document& document;
    Scene& scene;
    std::map<std::pair<std::size_t, bool>, uint> meshes; // (index in the file, mirrored) -> index in the level
    std::size_t instances = 0;
    Box staticBounds, allBounds;
};

std::string label(const json& thing, const char* kind, std::size_t i)
{
    const std::string name = text(thing, "name");
    return std::string(kind) + " " + (name.empty() ? std::to_string(i) : "\"" + name + "\"");
}

const json& list(const Walk& walk, const char* key) { return listOf(*walk.document.json, key); }

// The material's index in the level; plaster where the file names none.
uint materialOf(Walk& walk, const json& primitive)
{
    Scene& scene = walk.scene;
    const std::size_t count = list(walk, "materials").size();
    if (const auto material = index(primitive, "material", count)) return uint(*material);
    if (scene.materials.size() == count) {
        scene.materials.push_back(plaster());
        scene.materialNames.push_back("plaster");
        scene.warnings.push_back("some primitives have no material and are shown as grey plaster");
    }
    return uint(count);
}

bool readsTangents(const Material& material) { return material.normalTexture.texture >= 0 || material.anisotropy > 0.0f; }

void append(Scene& scene, Mesh& mesh, const Triangles& triangles, uint material)
{
    if (triangles.vertices.size() > kMostElements - scene.vertices.size() ||
        triangles.indices.size() > kMostElements - scene.indices.size())
        throw Malformed("the level has more vertices than 32 bits number");
    mesh.primitives.push_back({uint(scene.vertices.size()), uint(triangles.vertices.size()), uint(scene.indices.size()),
                               uint(triangles.indices.size()), material});
    scene.vertices.insert(scene.vertices.end(), triangles.vertices.begin(), triangles.vertices.end());
    scene.indices.insert(scene.indices.end(), triangles.indices.begin(), triangles.indices.end());
}

// Calls use(triangles, material) for each primitive of a mesh of the file that has triangles.
template <typename Use>
void readMesh(Walk& walk, std::size_t i, Dropped& dropped, const Use& use)
{
    const json& source = list(walk, "meshes")[i];
    const json& primitives = listOf(source, "primitives");
    for (std::size_t p = 0; p < primitives.size(); ++p) {
        try {
            const uint material = materialOf(walk, primitives[p]);
            const Tangents tangents = readsTangents(walk.scene.materials[material]) ? Tangents::followTexture : Tangents::arbitrary;
            const Triangles triangles = readTriangles(walk.document, primitives[p], tangents, dropped);
            if (!triangles.indices.empty()) use(triangles, material);
        } catch (const Malformed& problem) {
            throw Malformed(label(source, "mesh", i) + ", primitive " + std::to_string(p) + ": " + problem.what());
        }
    }
}

// The mesh in the level, read when it is placed for the first time. A mirrored one is a copy, reflected.
uint meshOf(Walk& walk, std::size_t i, bool mirrored)
{
    const auto [place, isNew] = walk.meshes.try_emplace({i, mirrored}, uint(walk.scene.meshes.size()));
    if (!isNew) return place->second;
    Mesh mesh{label(list(walk, "meshes")[i], "mesh", i)};
    if (const std::string name = text(list(walk, "meshes")[i], "name"); !name.empty()) mesh.name = name;
    Dropped again; // a second reading must not count twice
    Dropped& dropped = walk.meshes.contains({i, !mirrored}) ? again : walk.scene.dropped;
    readMesh(walk, i, dropped, [&](Triangles triangles, uint material) {
        if (mirrored) reflect(triangles.vertices, triangles.indices);
        append(walk.scene, mesh, triangles, material);
    });
    walk.scene.meshes.push_back(std::move(mesh));
    return place->second;
}

void grow(Box& box, const dmat4& toWorld, const Vertex& vertex)
{
    const dvec3 p(toWorld * dvec4(dvec3(vertex.position), 1.0));
    box.lower = min(box.lower, p);
    box.upper = max(box.upper, p);
}

void grow(Box& box, const Box& other)
{
    box.lower = min(box.lower, other.lower);
    box.upper = max(box.upper, other.upper);
}

Box boundsOf(const Scene& scene, const Mesh& mesh, const dmat4& toWorld)
{
    Box box;
    for (const Primitive& primitive : mesh.primitives)
        for (uint v = 0; v < primitive.vertexCount; ++v) grow(box, toWorld, scene.vertices[primitive.firstVertex + v]);
    return box;
}

bool withinReach(const Box& box)
{
    const dvec3 reach = max(abs(box.lower), abs(box.upper));
    return std::max({reach.x, reach.y, reach.z}) <= double(kLargestCoordinate);
}

// One copy of a mesh in the world, unless it would be nothing there.
void place(Walk& walk, std::size_t mesh, Object object, dmat4 toWorld)
{
    Scene& scene = walk.scene;
    if (!invertible(toWorld)) {
        if (scene.dropped["instances flattened to nothing"]++ == 0)
            scene.warnings.push_back("node \"" + object.name +
                                     "\" is scaled to nothing in an axis and is left out; apply its scale to the mesh");
        return;
    }
    const bool mirrored = mirrors(toWorld);
    object.mesh = meshOf(walk, mesh, mirrored);
    object.toWorld = mirrored ? toWorld * reflection() : toWorld;
    const Mesh& placed = scene.meshes[object.mesh];
    if (placed.primitives.empty()) return;

    const Box box = boundsOf(scene, placed, object.toWorld);
    if (!withinReach(box)) {
        ++scene.dropped["instances beyond 1e18 m"];
        return;
    }
    if (length(box.upper - box.lower) < kSmallestSize) {
        ++scene.dropped["instances too small to have an area"];
        return;
    }
    walk.instances += placed.primitives.size();
    if (walk.instances > kMostInstances)
        throw Malformed("the level places more than " + std::to_string(kMostInstances) +
                        " primitives, which is the most that can be drawn");
    grow(walk.allBounds, box);
    if (object.isStatic) grow(walk.staticBounds, box);
    scene.objects.push_back(std::move(object));
}

// The mesh's inside becomes a medium: the box around it.
void placeMedium(Walk& walk, std::size_t mesh, Medium medium, const dmat4& toWorld)
{
    if (medium.scattering == vec3(0.0f) && medium.absorption == vec3(0.0f)) return;
    Box box;
    readMesh(walk, mesh, walk.scene.dropped, [&](const Triangles& triangles, uint) {
        for (const Vertex& vertex : triangles.vertices) grow(box, toWorld, vertex);
    });
    const bool hollow = !(box.lower.x < box.upper.x && box.lower.y < box.upper.y && box.lower.z < box.upper.z);
    if (hollow || !withinReach(box)) {
        ++walk.scene.dropped["fog boxes without an inside"];
        return;
    }
    medium.lower = vec3(box.lower);
    medium.upper = vec3(box.upper);
    walk.scene.media.push_back(medium);
}

void visit(Walk& walk, std::size_t i, const dmat4& toWorld)
{
    Scene& scene = walk.scene;
    const json& node = list(walk, "nodes")[i];
    const std::string name = text(node, "name", "node " + std::to_string(i));
    const Extras extras{member(node, "extras"), label(node, "node", i), scene};
    const auto mesh = index(node, "mesh", list(walk, "meshes").size());
    const auto camera = index(node, "camera", list(walk, "cameras").size());
    const json& lights = listOf(extension(*walk.document.json, "KHR_lights_punctual"), "lights");
    const auto light = index(extension(node, "KHR_lights_punctual"), "light", lights.size());

    if (mesh) {
        const auto medium = readMedium(extras);
        if (!member(node, "skin").is_null()) scene.warnings.push_back(extras.owner + ": its skin is not read; the mesh stays as modelled");
        Object object{.name = name, .node = int(i)};
        readObjectExtras(extras, object);
        for (const dmat4& copy : copies(walk.document, node, kMostInstances)) {
            if (medium)
                placeMedium(walk, *mesh, *medium, toWorld * copy);
            else
                place(walk, *mesh, object, toWorld * copy);
        }
    }
    if (light) {
        if (auto read = readLight(lights[*light], toWorld, scene.dropped)) {
            readLightExtras(extras, *read);
            scene.lights.push_back(*read);
            scene.lightNames.push_back(name);
        }
    }
    if (camera) {
        if (auto read = readCamera(list(walk, "cameras")[*camera], toWorld, scene.dropped)) {
            read->name = name;
            scene.cameras.push_back(*read);
        }
    }
    if (!mesh && !light && !camera) readEmptyExtras(extras, toWorld, name);
}

bool usable(const dmat4& toWorld)
{
    for (int axis = 0; axis < 4; ++axis)
        for (int row = 0; row < 3; ++row)
            if (!(std::abs(toWorld[axis][row]) <= double(kLargestCoordinate))) return false;
    return true;
}

// From the roots downwards, children in order. A node that is met twice (two parents, or a circle) is visited once.
void walkNodes(Walk& walk, const json& roots)
{
    struct Step {
        std::size_t node;
        dmat4 parent;
    };
    const json& nodes = list(walk, "nodes");
    std::vector<Step> ahead;
    std::vector<bool> seen(nodes.size(), false);
    const auto push = [&](const json& children, const dmat4& parent) {
        for (std::size_t c = children.size(); c-- > 0;) {
            if (!children[c].is_number_unsigned() || children[c].get<std::uint64_t>() >= nodes.size())
                throw Malformed("it names node " + children[c].dump() + ", and there are only " + std::to_string(nodes.size()));
            ahead.push_back({children[c].get<std::size_t>(), parent});
        }
    };
    push(roots, dmat4(1.0));
    while (!ahead.empty()) {
        const Step step = ahead.back();
        ahead.pop_back();
        if (seen[step.node]) {
            ++walk.scene.dropped["nodes met twice"];
            continue;
        }
        seen[step.node] = true;
        const dmat4 toWorld = step.parent * localTransform(nodes[step.node]);
        if (!usable(toWorld)) {
            ++walk.scene.dropped["nodes beyond 1e18 m"];
            continue;
        }
        visit(walk, step.node, toWorld);
        push(listOf(nodes[step.node], "children"), toWorld);
    }
}

// The nodes that are nobody's child: the roots of a file without scenes.
json parentless(const json& nodes)
{
    std::set<std::uint64_t> children;
    for (const json& node : nodes)
        for (const json& child : listOf(node, "children"))
            if (child.is_number_unsigned()) children.insert(child.get<std::uint64_t>());
    json roots = json::array();
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (!children.contains(i)) roots.push_back(i);
    return roots;
}

void readLevel(const Document& document, Scene& scene)
{
    const json& gltf = *document.json;
    readMaterials(document, scene);
    if (!listOf(gltf, "animations").empty()) scene.warnings.push_back("its animations are not read; the level stays as at rest");

    const json& scenes = listOf(gltf, "scenes");
    const auto chosen = index(gltf, "scene", scenes.size());
    const json& source = scenes.empty() ? member(gltf, "") : scenes[chosen.value_or(0)];
    readSceneExtras(document, {member(source, "extras"), "the scene", scene});
    Walk walk{document, scene};
    walkNodes(walk, scenes.empty() ? parentless(listOf(gltf, "nodes")) : listOf(source, "nodes"));

    const bool hasStatic = walk.staticBounds.lower.x <= walk.staticBounds.upper.x;
    const Box& box = hasStatic ? walk.staticBounds : walk.allBounds;
    if (box.lower.x <= box.upper.x) {
        scene.lower = vec3(box.lower);
        scene.upper = vec3(box.upper);
    }
}
}

Scene loadLevel(const std::filesystem::path& path)
{
    Scene scene;
    scene.path = path;
    try {
        readLevel(openDocument(path), scene);
    } catch (const Malformed& problem) {
        throw Error(path.string() + " cannot be read: " + problem.what());
    } catch (const nlohmann::json::exception&) {
        throw Error(path.string() + " cannot be read: its JSON is not as glTF says; export it again");
    } catch (const std::filesystem::filesystem_error& problem) {
        throw Error(path.string() + " cannot be read: " + problem.code().message());
    }
    return scene;
}
}
