// Reads a level: its materials, then the nodes of its scene from the roots downwards, each placing what it holds.
#include "engine/core/error.hpp"
#include "engine/scene/convex.hpp"
#include "engine/scene/extras.hpp"
#include "engine/scene/fields.hpp"
#include "engine/scene/lens.hpp"
#include "engine/scene/light.hpp"
#include "engine/scene/material.hpp"
#include "engine/scene/meshes.hpp"
#include "engine/scene/nodes.hpp"
#include "engine/scene/origin.hpp"
#include "engine/scene/placement.hpp"
#include "shaders/color.h"
#include <algorithm>
#include <nlohmann/json.hpp>

namespace afterglow
{
namespace
{
using nlohmann::json;

constexpr std::size_t kMostInstances = 16777215; // 24 bits: what an acceleration structure can number
constexpr double kSmallestSize = 1e-15;          // m: below it the area of a triangle, squared, is no float

struct PlacedNode {
    std::size_t node;
    dmat4 toWorld;
};
struct Cloud {
    Medium medium; // its bounds not yet set
    Box box;
    std::vector<dvec4> planes; // that cut the box
};

// A level while it is read. Matrices and boxes are in its own coordinates until rebase().
struct Level {
    const Document& document;
    Scene& scene;
    Meshes meshes;
    std::size_t instances = 0;
    Box standing, all; // bounds of static objects, of all
    std::vector<Cloud> clouds;
};

const json& list(const Level& level, const char* key) { return listOf(*level.document.json, key); }

// One copy of a mesh in the world, unless it would be nothing there.
void place(Level& level, std::size_t mesh, Object object, const dmat4& toWorld)
{
    Scene& scene = level.scene;
    if (!invertible(toWorld)) {
        if (scene.dropped["instances flattened to nothing"]++ == 0)
            scene.warnings.push_back("node \"" + object.name +
                                     "\" is scaled to nothing in an axis and is left out; apply its scale to the mesh");
        return;
    }
    const bool mirrored = mirrors(toWorld);
    object.mesh = meshOf(level.meshes, mesh, mirrored);
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
    level.instances += placed.primitives.size();
    if (level.instances > kMostInstances)
        throw Malformed("the level places more than " + std::to_string(kMostInstances) + " primitives, the most that can be drawn");
    grow(level.all, box);
    if (object.isStatic) grow(level.standing, box);
    scene.objects.push_back(std::move(object));
}

bool isNothing(const Medium& medium)
{
    return medium.scattering == vec3(0.0f) && medium.absorption == vec3(0.0f) && medium.emission == vec3(0.0f);
}

// The mesh's inside becomes a medium where the mesh is a convex body, else the box around it.
void placeMedium(Level& level, std::size_t mesh, Medium medium, const std::string& name, const dmat4& toWorld)
{
    if (isNothing(medium)) return;
    const std::vector<dvec3> triangles = trianglesOf(level.document, mesh, toWorld, level.scene.dropped);
    Box box;
    for (const dvec3& corner : triangles) grow(box, corner);
    if (box.hollow() || !withinReach(box)) {
        ++level.scene.dropped["fog boxes without an inside"];
        return;
    }
    auto planes = convexPlanes(triangles);
    if (!planes)
        level.scene.warnings.push_back("node \"" + name + "\": its mesh is no closed convex body of at most " +
                                       std::to_string(kMostPlanes) + " sides, so its fog fills the box around it");
    level.clouds.push_back({medium, box, planes.value_or(std::vector<dvec4>{})});
}

// Light wanders in dense fog: depth^2 collisions to leave it, or as many as it survives.
void tellDense(Level& level, const Medium& medium, double across) // m
{
    constexpr double kMany = 1e4; // collisions: where a path of 20 ms begins
    const double scattering = double(luminance(medium.scattering)), absorption = double(luminance(medium.absorption));
    const double depth = scattering * across;
    const double survived = absorption > 0.0 ? scattering / absorption : kMany + 1.0;
    if (depth * depth > kMany && survived > kMany)
        level.scene.warnings.push_back("the scene: its fog scatters " + std::to_string(std::int64_t(std::min(depth, 1e15))) +
                                       " times across the level, and its light takes very long to bake or trace; make it thinner");
}

// The level's air: everything drawn stands in it, and a margin lies around, so that sky and sun come in dimmed by a finite way.
void fillLevel(Level& level, Medium medium)
{
    constexpr double kMargin = 0.1; // of the box's diagonal, on every side: the same fog at any scale
    if (isNothing(medium)) return;
    if (level.all.empty()) {
        level.scene.warnings.push_back("the scene: its fog fills the level, and the level draws nothing");
        return;
    }
    const double margin = kMargin * length(level.all.upper - level.all.lower); // m
    medium.wholeLevel = 1;
    tellDense(level, medium, length(level.all.upper - level.all.lower) + 2.0 * margin);
    level.clouds.insert(level.clouds.begin(), {medium, {level.all.lower - margin, level.all.upper + margin}, {}});
}

// Blender writes a custom property where its author typed it: on the object (the node) or on its data (mesh, light). The node's wins.
json together(const json& node, const json& data)
{
    json extras = member(data, "extras").is_object() ? member(data, "extras") : json::object();
    if (member(node, "extras").is_object()) extras.update(member(node, "extras"));
    return extras;
}

void visitMesh(Level& level, std::size_t mesh, const json& node, Object object, const Extras& extras, const dmat4& toWorld)
{
    if (!member(node, "skin").is_null())
        level.scene.warnings.push_back(extras.owner + ": its skin is not read; the mesh stays as modelled");
    const auto medium = readMedium(extras);
    readObjectExtras(extras, object);
    for (const dmat4& copy : copies(level.document, node, kMostInstances)) {
        if (medium)
            placeMedium(level, mesh, *medium, object.name, toWorld * copy);
        else
            place(level, mesh, object, toWorld * copy);
    }
}

std::string nameOf(const json& node, std::size_t i) { return text(node, "name", "node " + std::to_string(i)); }

void visitMeshes(Level& level, std::size_t i, const dmat4& toWorld)
{
    const json& node = list(level, "nodes")[i];
    const auto mesh = index(node, "mesh", list(level, "meshes").size());
    if (!mesh) return;
    const json extras = together(node, list(level, "meshes")[*mesh]);
    visitMesh(level, *mesh, node, {.name = nameOf(node, i), .node = int(i)}, {extras, label(node, "node", i), level.scene}, toWorld);
}

// Lights, cameras, and what is placed by hand.
void visitOthers(Level& level, std::size_t i, const dmat4& toWorld)
{
    Scene& scene = level.scene;
    const json& node = list(level, "nodes")[i];
    const std::string name = nameOf(node, i), owner = label(node, "node", i);
    const json& lights = listOf(extension(*level.document.json, "KHR_lights_punctual"), "lights");
    const auto mesh = index(node, "mesh", list(level, "meshes").size());
    const auto light = index(extension(node, "KHR_lights_punctual"), "light", lights.size());
    const auto camera = index(node, "camera", list(level, "cameras").size());
    if (light) {
        if (auto read = readLight(lights[*light], toWorld, scene.dropped)) {
            const json extras = together(node, lights[*light]);
            readLightExtras({extras, owner, scene}, *read);
            scene.lights.push_back(*read);
            scene.lightNames.push_back(name);
        }
    }
    if (camera) {
        if (auto read = readCamera(list(level, "cameras")[*camera], toWorld, scene.dropped)) {
            read->name = name;
            scene.cameras.push_back(*read);
        }
    }
    if (!mesh && !light && !camera) readEmptyExtras({member(node, "extras"), owner, scene}, toWorld, name);
}

// From here on positions count from the scene's origin, and only now do they become floats.
void rebase(Level& level, std::vector<PlacedNode>& nodes)
{
    Scene& scene = level.scene;
    const Box& box = level.standing.empty() ? level.all : level.standing;
    scene.origin = originOf(box);
    for (PlacedNode& node : nodes) node.toWorld = fromLevel(node.toWorld, scene.origin);
    for (Object& object : scene.objects) object.toWorld = fromLevel(object.toWorld, scene.origin);
    for (Cloud& cloud : level.clouds) {
        cloud.medium.lower = fromLevel(cloud.box.lower, scene.origin);
        cloud.medium.upper = fromLevel(cloud.box.upper, scene.origin);
        cloud.medium.firstPlane = uint(scene.mediumPlanes.size());
        cloud.medium.planeCount = uint(cloud.planes.size());
        for (const dvec4& plane : cloud.planes)
            scene.mediumPlanes.push_back(vec4(vec3(plane), float(plane.w - dot(dvec3(plane), scene.origin))));
        scene.media.push_back(cloud.medium);
    }
    if (box.empty()) return;
    scene.lower = fromLevel(box.lower, scene.origin);
    scene.upper = fromLevel(box.upper, scene.origin);
}

void readLevel(const Document& document, Scene& scene)
{
    const json& gltf = *document.json;
    const std::vector<bool> secondUv = readMaterials(document, scene);
    for (const std::string& name : document.unread)
        scene.warnings.push_back("it uses " + name + ", which is not read: it may look different");
    if (!listOf(gltf, "animations").empty()) scene.warnings.push_back("its animations are not read; the level stays as at rest");

    const json& scenes = listOf(gltf, "scenes");
    const json& source = scenes.empty() ? member(gltf, "") : scenes[index(gltf, "scene", scenes.size()).value_or(0)];
    const Extras extras{member(source, "extras"), "the scene", scene};
    readSceneExtras(document, extras);
    Level level{document, scene, {document, scene, secondUv, {}}};
    std::vector<PlacedNode> nodes;
    walkNodes(document, source, scene.dropped, [&](std::size_t node, const dmat4& toWorld) { nodes.push_back({node, toWorld}); });
    for (const PlacedNode& node : nodes) visitMeshes(level, node.node, node.toWorld);
    if (const auto air = readMedium(extras)) fillLevel(level, *air);
    rebase(level, nodes);
    for (const PlacedNode& node : nodes) visitOthers(level, node.node, node.toWorld);
}
}

std::string droppedText(const Scene& scene)
{
    std::string list;
    for (const auto& [what, count] : scene.dropped) list += (list.empty() ? "" : ", ") + what + " (" + std::to_string(count) + ")";
    return list.empty() ? "" : scene.path.filename().string() + ": left out or put within bounds: " + list;
}

// Reads, and says what is wrong with the level in one sentence.
template <class Read>
static void reading(const std::filesystem::path& path, Read read)
{
    const auto fail = [&](const std::string& problem) { throw Error(path.string() + " cannot be read: " + problem); };
    try {
        read();
    } catch (const Malformed& problem) {
        fail(problem.what());
    } catch (const nlohmann::json::exception&) {
        fail("its JSON is not as glTF says; export it again");
    } catch (const std::filesystem::filesystem_error& problem) {
        fail(problem.code().message());
    } catch (const std::bad_alloc&) {
        fail("it needs more memory than there is");
    }
}

Scene loadLevel(const std::filesystem::path& path)
{
    Scene scene;
    scene.path = path;
    reading(path, [&] { readLevel(openDocument(path), scene); });
    return scene;
}

std::vector<std::filesystem::path> filesOf(const std::filesystem::path& level)
{
    std::vector<std::filesystem::path> files = {level};
    const auto add = [&](const json& uri) {
        if (uri.is_string() && !uri.get<std::string>().starts_with("data:")) files.push_back(besideLevel(level, uri.get<std::string>()));
    };
    reading(level, [&] {
        const Document document = openDocument(level);
        for (const char* kind : {"buffers", "images"})
            for (const json& resource : listOf(*document.json, kind)) add(member(resource, "uri"));
        for (const json& scene : listOf(*document.json, "scenes")) add(member(member(scene, "extras"), "ag_sky_image"));
    });
    return files;
}
}
