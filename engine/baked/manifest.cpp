#include "engine/baked/manifest.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include "engine/scene/origin.hpp"
#include <algorithm>
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

static constexpr const char* kGenerator = "afterglow "; // then the version

static json vectorText(dvec3 v) { return {v.x, v.y, v.z}; }

static void countLightmaps(json& product, const Baked& baked)
{
    std::uint64_t texels = 0, valid = 0;
    json pages = json::array();
    for (const Lightmap& page : baked.lightmaps) {
        texels += page.valid.size();
        valid += std::uint64_t(std::count(page.valid.begin(), page.valid.end(), 1));
        pages.push_back({{"width", page.width}, {"height", page.height}});
    }
    product["pages"] = std::move(pages);
    product["directional"] = !baked.lightmaps[0].direction.empty();
    product["texels"] = texels;
    product["valid_texels"] = valid;
    if (!product.contains("utilisation")) product["utilisation"] = texels > 0 ? double(valid) / double(texels) : 0.0;
}

static void countProbes(json& product, const Baked& baked)
{
    product["count"] = baked.probes.probes.size();
    product["cells"] = baked.probes.cells.size();
    vec3 lower(kFloatMax), upper(-kFloatMax);
    for (vec3 position : baked.probes.positions) lower = min(lower, position), upper = max(upper, position);
    product["lower"] = vectorText(toLevel(dvec3(lower), baked.scene.origin));
    product["upper"] = vectorText(toLevel(dvec3(upper), baked.scene.origin));
}

static void countReflections(json& product, const Baked& baked)
{
    json probes = json::array();
    for (const ReflectionProbe& probe : baked.reflections)
        probes.push_back({{"name", probe.name},
                          {"position", vectorText(toLevel(probe.position, baked.scene.origin))},
                          {"box_lower", vectorText(toLevel(probe.boxLower, baked.scene.origin))},
                          {"box_upper", vectorText(toLevel(probe.boxUpper, baked.scene.origin))},
                          {"size", probe.size},
                          {"mips", probe.mips.size()}});
    product["count"] = probes.size();
    product["probes"] = std::move(probes);
}

static void countVoxels(json& product, const Baked& baked)
{
    const VoxelGrid& grid = baked.voxels;
    product["count"] = {grid.count.x, grid.count.y, grid.count.z};
    product["edge"] = grid.edge;
    product["lower"] = vectorText(toLevel(grid.lower, baked.scene.origin));
}

// Levels of detail live in scene.glb: they have counts, and their indices have bytes.
static void countLods(json& product, const Baked& baked)
{
    std::uint64_t levels = 0, triangles = 0, meshes = 0;
    for (const MeshLods& mesh : baked.lods) {
        std::uint64_t here = 0;
        for (const auto& primitive : mesh.primitives) {
            here += primitive.size();
            for (const LodLevel& level : primitive) triangles += level.indices.size() / 3;
        }
        meshes += here > 0 ? 1 : 0;
        levels += here;
    }
    product["meshes"] = meshes;
    product["levels"] = levels;
    product["triangles"] = triangles;
    product["files"] = {"scene.glb"};
    product["bytes"] = triangles * 3 * sizeof(std::uint32_t);
}

void completeManifest(json& manifest, const Baked& baked, const std::vector<BakedFile>& files)
{
    if (!manifest.is_object()) manifest = json::object();
    manifest["schema"] = kBakeSchema;
    manifest["generator"] = std::string(kGenerator) + AFTERGLOW_VERSION;
    manifest["direct"] = baked.directAll ? "all" : "as-said";
    if (!manifest.contains("level")) manifest["level"] = {{"path", baked.scene.path.filename().string()}};
    if (!manifest.contains("warnings")) manifest["warnings"] = baked.scene.warnings;

    json& products = manifest["products"];
    if (!baked.lightmaps.empty()) countLightmaps(products["lightmaps"], baked);
    if (!baked.probes.empty()) countProbes(products["probes"], baked);
    if (!baked.reflections.empty()) countReflections(products["reflections"], baked);
    if (!baked.lods.empty()) countLods(products["lods"], baked);
    if (!baked.voxels.closed.empty()) countVoxels(products["voxels"], baked);
    manifest["sha256"] = json::object();
    for (const BakedFile& file : files) {
        json& product = products[file.product];
        product["files"].push_back(file.name);
        product["bytes"] = product.value("bytes", std::uint64_t(0)) + file.bytes.size();
        manifest["sha256"][file.name] = sha256(file.bytes.data(), file.bytes.size());
    }
}

json readManifest(const std::filesystem::path& directory)
{
    const std::filesystem::path path = directory / "bake.json";
    std::error_code none;
    if (!std::filesystem::exists(directory, none))
        throw Error("cannot read " + directory.string() + ": there is no such folder; check the name");
    if (!std::filesystem::is_regular_file(path, none))
        throw Error(directory.string() + " is not a bake: it has no bake.json; make one with `afterglow bake LEVEL -o DIR`");
    const json manifest = json::parse(readText(path), nullptr, /* allow_exceptions= */ false);
    if (!manifest.is_object() || !manifest.contains("schema") || !manifest["schema"].is_number_integer() ||
        !manifest.contains("products") || !manifest["products"].is_object())
        throw Error("cannot read " + path.string() + ": it is damaged or not the bake.json of a bake; remove " + directory.string() +
                    " and bake the level again");
    if (manifest["schema"] != kBakeSchema)
        throw Error("cannot read " + path.string() + ": it has schema " + manifest["schema"].dump() + ", and this program reads " +
                    std::to_string(kBakeSchema) + "; bake the level again");
    return manifest;
}

std::optional<std::set<std::string>> ownFiles(const std::filesystem::path& directory)
{
    std::error_code none;
    const std::filesystem::path path = directory / "bake.json";
    if (!std::filesystem::is_regular_file(path, none)) return std::nullopt;
    const json manifest = json::parse(readText(path), nullptr, /* allow_exceptions= */ false);
    const auto has = [&](const char* key, auto is) { return manifest.contains(key) && (manifest[key].*is)(); };
    if (!manifest.is_object() || !has("schema", &json::is_number_integer) || !has("generator", &json::is_string) ||
        !has("products", &json::is_object) || !manifest["generator"].get<std::string>().starts_with(kGenerator))
        return std::nullopt;
    std::set<std::string> names = {"bake.json"};
    for (const json& product : manifest["products"])
        for (const char* list : {"files", "masters"})
            if (product.is_object() && product.contains(list) && product[list].is_array())
                for (const json& name : product[list])
                    if (name.is_string()) names.insert(name.get<std::string>());
    return names;
}

static bool isPlainName(const std::string& name)
{
    return !name.empty() && name.find('/') == std::string::npos && name.find('\\') == std::string::npos && name[0] != '.';
}

std::vector<std::string> productFiles(const json& manifest, const std::string& product, const std::string& suffix,
                                      const std::filesystem::path& directory)
{
    std::vector<std::string> names;
    const json& products = manifest["products"];
    if (!products.is_object() || !products.contains(product)) return names;
    const Error damaged("cannot read " + (directory / "bake.json").string() + ": its list of " + product + " is damaged; remove " +
                        directory.string() + " and bake the level again");
    if (!products[product].is_object() || !products[product].contains("files") || !products[product]["files"].is_array()) throw damaged;
    for (const json& file : products[product]["files"]) {
        if (!file.is_string() || !isPlainName(file.get<std::string>())) throw damaged;
        if (file.get<std::string>().ends_with(suffix)) names.push_back(file.get<std::string>());
    }
    return names;
}

std::vector<std::uint8_t> readBakedFile(const json& manifest, const std::filesystem::path& directory, const std::string& name)
{
    std::error_code none;
    if (!std::filesystem::exists(directory / name, none))
        throw Error("cannot read " + (directory / name).string() + ": it is missing from the bake; bake the level again");
    std::vector<std::uint8_t> bytes = readFile(directory / name);
    if (!manifest.contains("sha256") || !manifest["sha256"].is_object() || !manifest["sha256"].contains(name)) return bytes;
    if (manifest["sha256"][name] != sha256(bytes.data(), bytes.size()))
        throw Error(
            "cannot read " + (directory / name).string() +
            ": it is truncated or changed since the bake; bake again, or remove its line from sha256 in bake.json to accept the change");
    return bytes;
}
}
