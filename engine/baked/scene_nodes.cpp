#include "engine/baked/scene_nodes.hpp"
#include "engine/core/error.hpp"
#include "engine/scene/fields.hpp"
#include "engine/scene/origin.hpp"
#include "engine/scene/placement.hpp"
#include <cmath>
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

// World matrices as import computes them, to the bit; nodes outside the level's scene keep the identity.
static std::vector<dmat4> worldMatrices(const json& document)
{
    const json& nodes = listOf(document, "nodes");
    std::vector<dmat4> world(nodes.size(), dmat4(1.0));
    std::vector<bool> child(nodes.size(), false), seen(nodes.size(), false);
    for (const json& node : nodes)
        for (const json& c : listOf(node, "children"))
            if (c.get<std::size_t>() < nodes.size()) child[c.get<std::size_t>()] = true;
    std::vector<std::size_t> ahead;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (child[i]) continue;
        world[i] = dmat4(1.0) * localTransform(nodes[i]);
        ahead.push_back(i);
    }
    while (!ahead.empty()) {
        const std::size_t node = ahead.back();
        ahead.pop_back();
        seen[node] = true;
        for (const json& c : listOf(nodes[node], "children")) {
            const std::size_t i = c.get<std::size_t>();
            if (i >= nodes.size() || seen[i]) continue;
            world[i] = world[node] * localTransform(nodes[i]);
            ahead.push_back(i);
        }
    }
    return world;
}

static void writePlace(json& node, const LightmapPlace& place)
{
    if (node.contains("extras") && node["extras"].is_object()) node["extras"].erase("ag_lightmap");
    if (place.page < 0) return;
    if (!node.contains("extras") || !node["extras"].is_object()) node["extras"] = json::object();
    node["extras"]["ag_lightmap"] = {
        {"page", place.page}, {"scale", {place.scale.x, place.scale.y}}, {"offset", {place.offset.x, place.offset.y}}};
}

// The node at `index` shows the mesh; coarser ones are nodes of their own that no scene names.
static void writeMeshAndLods(json& nodes, std::size_t index, const WrittenMesh& mesh)
{
    nodes[index]["mesh"] = mesh.meshes[0];
    if (mesh.meshes.size() == 1) return;
    json ids = json::array();
    for (std::size_t level = 1; level < mesh.meshes.size(); ++level) {
        json coarser = {{"mesh", mesh.meshes[level]}};
        for (const char* key : {"translation", "rotation", "scale", "matrix"})
            if (nodes[index].contains(key)) coarser[key] = nodes[index][key];
        if (nodes[index].contains("name")) coarser["name"] = nodes[index]["name"].get<std::string>() + " lod " + std::to_string(level);
        ids.push_back(nodes.size());
        nodes.push_back(std::move(coarser));
    }
    nodes[index]["extensions"]["MSFT_lod"]["ids"] = std::move(ids);
    nodes[index]["extras"]["MSFT_screencoverage"] = mesh.screenCoverages;
}

// Extras that speak of the mesh go with it; the rest stays.
static json takeObjectExtras(json& node)
{
    json taken = json::object();
    if (!node.contains("extras") || !node["extras"].is_object()) return taken;
    for (const auto& [key, value] : node["extras"].items())
        if (key.starts_with("ag_")) taken[key] = value;
    for (const auto& [key, value] : taken.items()) node["extras"].erase(key);
    return taken;
}

static bool carriesMore(const json& node)
{
    return node.contains("children") || node.contains("camera") || !extension(node, "KHR_lights_punctual").is_null();
}

// A mesh that fills its inside with fog is no object, and stays (scene_glb.cpp brings its vertices along).
static bool isFog(const json& node)
{
    if (!node.contains("extras") || !node["extras"].is_object()) return false;
    for (const auto& [key, value] : node["extras"].items())
        if (key.starts_with("ag_fog_")) return true;
    return false;
}

static json matrixText(const dmat4& m)
{
    json numbers = json::array();
    for (int i = 0; i < 16; ++i) numbers.push_back(i % 4 == 3 ? (i == 15 ? 1.0 : 0.0) : m[i / 4][i % 4]);
    return numbers;
}

static bool nearly(const dmat4& a, const dmat4& b)
{
    double apart = 0.0;
    for (int i = 0; i < 16; ++i) apart = std::max(apart, std::abs(a[i / 4][i % 4] - b[i / 4][i % 4]));
    return apart < 1e-12;
}

void writeNodes(const Baked& baked, const std::vector<WrittenMesh>& meshes, json& document)
{
    if (!document.contains("nodes")) return;
    const Scene& scene = baked.scene;
    std::vector<dmat4> world = worldMatrices(document);
    for (dmat4& toWorld : world) toWorld = fromLevel(toWorld, scene.origin);
    std::vector<std::vector<std::size_t>> objects(world.size());
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        check(scene.objects[o].node >= 0 && std::size_t(scene.objects[o].node) < world.size(), "an object comes from a node of its level");
        objects[std::size_t(scene.objects[o].node)].push_back(o);
    }

    json& nodes = document["nodes"];
    for (std::size_t n = 0; n < world.size(); ++n) {
        if (!nodes[n].contains("mesh") || (objects[n].empty() && isFog(nodes[n]))) continue;
        for (const char* key : {"mesh", "skin", "weights"}) nodes[n].erase(key);
        if (nodes[n].contains("extensions")) {
            for (const char* key : {"EXT_mesh_gpu_instancing", "MSFT_lod"}) nodes[n]["extensions"].erase(key);
            if (nodes[n]["extensions"].empty()) nodes[n].erase("extensions");
        }
        const auto place = [&](std::size_t o) { return o < baked.places.size() ? baked.places[o] : LightmapPlace{}; };
        const auto meshOf = [&](std::size_t o) -> const WrittenMesh& { return meshes[scene.objects[o].mesh]; };
        if (objects[n].size() == 1 && scene.objects[objects[n][0]].toWorld == world[n] &&
            (meshOf(objects[n][0]).meshes.size() == 1 || !carriesMore(nodes[n]))) {
            writePlace(nodes[n], place(objects[n][0]));
            writeMeshAndLods(nodes, n, meshOf(objects[n][0]));
            continue;
        }
        const json extras = takeObjectExtras(nodes[n]);
        json children = json::array();
        for (std::size_t o : objects[n]) {
            json child = {{"name", scene.objects[o].name}};
            if (!extras.empty()) child["extras"] = extras;
            const dmat4 local = inverse(world[n]) * scene.objects[o].toWorld;
            if (nearly(local, reflection()))
                child["scale"] = {-1.0, 1.0, 1.0};
            else if (!nearly(local, dmat4(1.0)))
                child["matrix"] = matrixText(local);
            writePlace(child, place(o));
            children.push_back(nodes.size());
            nodes.push_back(std::move(child));
            writeMeshAndLods(nodes, nodes.size() - 1, meshOf(o));
        }
        // Before the children that were there: the order of objects stays.
        for (const json& other : listOf(nodes[n], "children")) children.push_back(other);
        if (!children.empty()) nodes[n]["children"] = std::move(children);
    }
}

void readNodes(const Document& document, Baked& baked)
{
    const json& nodes = listOf(*document.json, "nodes");
    const auto finite2 = [](const json& pair) {
        const vec2 v(pair.at(0).get<float>(), pair.at(1).get<float>());
        if (!std::isfinite(v.x) || !std::isfinite(v.y)) throw Malformed("a node's ag_lightmap is no number");
        return v;
    };
    bool anyLods = false, anyMute = false;
    baked.lods.assign(baked.scene.meshes.size(), {});
    for (const Object& object : baked.scene.objects) {
        const json& node = nodes.at(std::size_t(object.node));
        LightmapPlace& place = baked.places.emplace_back();
        if (const json& said = member(member(node, "extras"), "ag_lightmap"); !said.is_null()) {
            place.page = said.at("page").get<int>();
            place.scale = finite2(said.at("scale"));
            place.offset = finite2(said.at("offset"));
            if (place.page < 0) throw Malformed("a node's ag_lightmap names page " + std::to_string(place.page));
        }
        std::vector<std::size_t> levels;
        for (const json& id : listOf(extension(node, "MSFT_lod"), "ids"))
            levels.push_back(nodes.at(id.get<std::size_t>()).at("mesh").get<std::size_t>());
        MeshLods& lods = baked.lods[object.mesh];
        if (lods.primitives.empty()) lods = readLods(document, baked.scene, object.mesh, levels);
        anyLods = anyLods || !levels.empty();
        anyMute = anyMute || !sayTurns(document, levels);
    }
    if (!anyLods) baked.lods.clear();
    if (anyMute)
        baked.scene.warnings.push_back("its levels of detail do not say how far their normals turn, so they are not drawn: bake it again");
}
}
