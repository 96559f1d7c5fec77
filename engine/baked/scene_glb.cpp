#include "engine/baked/scene_glb.hpp"
#include "engine/baked/scene_nodes.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include "engine/scene/accessor.hpp"
#include "engine/scene/fields.hpp"
#include "engine/scene/texture.hpp"
#include <algorithm>
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

static const char* mimeType(std::span<const std::uint8_t> picture)
{
    return !picture.empty() && picture[0] == 0x89 ? "image/png" : "image/jpeg";
}

// Wherever it stands in the value.
static void eraseKey(json& value, const char* key)
{
    if (value.is_object()) value.erase(key);
    if (value.is_structured())
        for (json& part : value) eraseKey(part, key);
}

// The slot of a material in which the image is shown first: what stands in for it depends on that.
static Slot slotOf(const json& document, std::size_t image)
{
    const json &textures = listOf(document, "textures"), &images = listOf(document, "images");
    const auto shows = [&](const json& owner, const char* map) {
        const auto texture = index(member(owner, map), "index", textures.size());
        return texture && index(textures[*texture], "source", images.size()) == image;
    };
    for (const json& material : listOf(document, "materials")) {
        const json& metal = member(material, "pbrMetallicRoughness");
        if (shows(metal, "baseColorTexture")) return Slot::baseColor;
        if (shows(metal, "metallicRoughnessTexture")) return Slot::metallicRoughness;
        if (shows(material, "normalTexture")) return Slot::normal;
    }
    return Slot::emissive;
}

// A material that import moved to the first texture coordinates says so: the second are the lightmap's now.
static void moveToFirstUv(json& document, const Scene& scene)
{
    for (std::size_t i = 0; i < listOf(document, "materials").size(); ++i) {
        const Material& material = scene.materials[i];
        const bool second = material.baseColorTexture.uvSet == 1 || material.metallicRoughnessTexture.uvSet == 1 ||
                            material.normalTexture.uvSet == 1 || material.emissiveTexture.uvSet == 1 ||
                            material.transmissionTexture.uvSet == 1;
        if (!second) eraseKey(document["materials"][i], "texCoord");
    }
}

// Every picture moves into the file; for one that was missing, what import shows in its place.
static void embedImages(const Document& level, BinaryChunk& chunk, json& document)
{
    if (!document.contains("images")) return;
    for (std::size_t i = 0; i < document["images"].size(); ++i) {
        json& image = document["images"][i];
        std::vector<std::uint8_t> neutral;
        std::span<const std::uint8_t> picture = level.images.at(i);
        if (picture.empty() && image.contains("bufferView")) picture = viewBytes(level, image["bufferView"].get<std::size_t>());
        if (picture.empty()) {
            const auto texel = neutralTexel(slotOf(document, i));
            neutral = encodePng({1, 1, 4, {texel.begin(), texel.end()}});
            picture = neutral;
        }
        image.erase("uri");
        image["bufferView"] = addView(chunk, picture, ViewTarget::none);
        image["mimeType"] = mimeType(picture);
    }
}

static void copyAnimations(const Document& level, BinaryChunk& chunk, json& document)
{
    if (!document.contains("animations")) return;
    json kept = json::array();
    for (json& animation : document["animations"]) {
        json channels = json::array();
        for (const json& channel : animation["channels"])
            if (channel.at("target").at("path") != "weights") channels.push_back(channel); // of morph targets, which are not kept
        if (channels.empty()) continue;
        animation["channels"] = std::move(channels);
        for (json& sampler : animation["samplers"])
            for (const char* key : {"input", "output"}) sampler[key] = copyAccessor(chunk, level, sampler[key].get<std::size_t>());
        kept.push_back(animation);
    }
    document.erase("animations");
    if (!kept.empty()) document["animations"] = std::move(kept);
}

// Meshes that are no objects but volumes of fog, as the level has them.
static void copyFogMeshes(const Document& level, BinaryChunk& chunk, json& document, std::size_t levelNodes, const Scene& scene)
{
    std::vector<bool> isObject(levelNodes, false);
    for (const Object& object : scene.objects) isObject[std::size_t(object.node)] = true;
    std::map<std::size_t, std::size_t> copied;
    for (std::size_t n = 0; n < levelNodes; ++n) {
        json& node = document["nodes"][n];
        if (isObject[n] || !node.contains("mesh")) continue;
        const std::size_t source = node["mesh"].get<std::size_t>();
        const auto [copy, isNew] = copied.try_emplace(source, document["meshes"].size());
        node["mesh"] = copy->second;
        if (!isNew) continue;
        json mesh = level.json->at("meshes").at(source);
        mesh.erase("weights");
        for (json& primitive : mesh["primitives"]) {
            primitive.erase("targets");
            if (primitive.contains("extensions")) primitive.erase("extensions");
            for (auto& [name, accessor] : primitive["attributes"].items())
                accessor = copyAccessor(chunk, level, accessor.get<std::size_t>());
            if (primitive.contains("indices")) primitive["indices"] = copyAccessor(chunk, level, primitive["indices"].get<std::size_t>());
        }
        document["meshes"].push_back(std::move(mesh));
    }
}

// Name and extras of the mesh that the level's file gave this one.
static json namedAs(const Document& level, const Scene& scene, std::size_t mesh)
{
    json named = json::object();
    for (const Object& object : scene.objects) {
        if (object.mesh != mesh) continue;
        const json& source =
            level.json->at("meshes").at(level.json->at("nodes").at(std::size_t(object.node)).at("mesh").get<std::size_t>());
        for (const char* key : {"name", "extras"})
            if (source.contains(key)) named[key] = source[key];
        break;
    }
    return named;
}

// extensionsUsed and extensionsRequired after the rewriting: instances are nodes now, levels of detail are new.
static void setExtensions(json& document, bool lods)
{
    for (const char* key : {"extensionsUsed", "extensionsRequired"}) {
        json kept = json::array();
        for (const json& name : listOf(document, key))
            if (name != "EXT_mesh_gpu_instancing" && name != "MSFT_lod") kept.push_back(name);
        if (lods && key == std::string_view("extensionsUsed")) kept.push_back("MSFT_lod");
        document.erase(key);
        if (!kept.empty()) document[key] = std::move(kept);
    }
}

// The sky's picture lies beside the file, under a name of ours.
static void takeSky(const Document& level, json& document, SceneFiles& files)
{
    for (json& scene : document.contains("scenes") ? document["scenes"] : document) {
        if (!scene.is_object() || !scene.contains("extras") || !scene["extras"].is_object()) continue;
        const json& said = member(scene["extras"], "ag_sky_image");
        if (!said.is_string()) continue;
        const std::filesystem::path picture = besideLevel(level.path, said.get<std::string>());
        if (!std::filesystem::is_regular_file(picture)) {
            scene["extras"].erase("ag_sky_image"); // import has said so
            continue;
        }
        files.skyName = "sky" + picture.extension().string();
        files.sky = readFile(picture);
        scene["extras"]["ag_sky_image"] = files.skyName;
    }
}

static SceneFiles write(const Baked& baked)
{
    const Document level = openDocument(baked.scene.path);
    SceneFiles files;
    json document = *level.json;
    BinaryChunk chunk;
    document["asset"]["generator"] = "afterglow " AFTERGLOW_VERSION;
    document.erase("skins");
    document["meshes"] = json::array();

    std::vector<WrittenMesh> meshes;
    bool lods = false;
    for (std::size_t m = 0; m < baked.scene.meshes.size(); ++m) {
        meshes.push_back(
            writeMesh(baked, m, namedAs(level, baked.scene, m), listOf(document, "materials").size(), chunk, document["meshes"]));
        lods = lods || meshes.back().meshes.size() > 1;
    }
    const std::size_t levelNodes = listOf(document, "nodes").size();
    writeNodes(baked, meshes, document);
    copyFogMeshes(level, chunk, document, levelNodes, baked.scene);
    if (document["meshes"].empty()) document.erase("meshes");
    copyAnimations(level, chunk, document);
    moveToFirstUv(document, baked.scene);
    embedImages(level, chunk, document);
    setExtensions(document, lods);
    takeSky(level, document, files);
    files.glb = encodeGlb(std::move(document), chunk);
    return files;
}

SceneFiles writeScene(const Baked& baked)
{
    const std::string what = "cannot write the baked level: " + baked.scene.path.string() + ": ";
    try {
        return write(baked);
    } catch (const Malformed& problem) {
        throw Error(what + problem.what());
    } catch (const json::exception&) {
        throw Error(what + "its JSON is not as glTF says; export it again");
    } catch (const std::out_of_range&) {
        throw Error(what + "it names a part that is not there; export it again");
    }
}

void readScene(const std::filesystem::path& glb, Baked& baked)
{
    baked.scene = loadLevel(glb);
    try {
        readNodes(openDocument(glb), baked);
    } catch (const Malformed& problem) {
        throw Error("cannot read " + glb.string() + ": " + problem.what());
    } catch (const json::exception&) {
        throw Error("cannot read " + glb.string() + ": its ag_lightmap or MSFT_lod is damaged; bake the level again");
    }
}
}
