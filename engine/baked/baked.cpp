#include "engine/baked/baked.hpp"
#include "engine/baked/lightmap.hpp"
#include "engine/baked/manifest.hpp"
#include "engine/baked/probes.hpp"
#include "engine/baked/reflections.hpp"
#include "engine/baked/scene_glb.hpp"
#include "engine/baked/voxels.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include "engine/core/interrupt.hpp"
#include "engine/core/jobs.hpp"
#include "engine/core/scaffold.hpp"
#include <algorithm>
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

static constexpr const char *kCoverageEnd = "_coverage.ktx2", *kDirectionEnd = "_direction.ktx2";

// ---- Writing ------------------------------------------------------------------------------------------------------------------------

static std::string numbered(const char* name, std::size_t i, const char* rest) { return name + std::to_string(i) + rest; }

// Of a lightmap page: colour, coverage, and the direction where the bake knows it.
static std::size_t filesOfPage(const Baked& baked) { return baked.lightmaps.empty() || baked.lightmaps[0].direction.empty() ? 2 : 3; }

static BakedFile pageFile(const Lightmap& page, std::size_t number, std::size_t kind)
{
    if (kind == 0) return {"lightmaps", numbered("lightmap_", number, ".ktx2"), encodeKtx2(lightmapTexture(page))};
    if (kind == 1) return {"lightmaps", numbered("lightmap_", number, kCoverageEnd), encodeKtx2(coverageTexture(page))};
    return {"lightmaps", numbered("lightmap_", number, kDirectionEnd), encodeKtx2(directionTexture(page))};
}

static const std::string kProbeFile = "irradiance.ktx2", kProbeTreeFile = "irradiance_tree.ktx2";
static std::size_t probeFiles(const Baked& baked) { return baked.probes.empty() ? 0 : 2; }

static std::vector<BakedFile> productsOf(const Baked& baked, const Advance& advance)
{
    SceneFiles scene = writeScene(baked);
    std::vector<BakedFile> files;
    files.push_back({"scene", "scene.glb", std::move(scene.glb)});
    if (!scene.skyName.empty()) files.push_back({"scene", scene.skyName, std::move(scene.sky)});

    // Textures are packed side by side; each has its place.
    const std::size_t each = filesOfPage(baked), pages = baked.lightmaps.size(), probes = probeFiles(baked),
                      cubes = baked.reflections.size();
    const std::size_t first = files.size();
    files.resize(first + each * pages + probes + cubes + (baked.voxels.closed.empty() ? 0 : 1));
    parallelFor(files.size() - first, 0, [&](std::size_t i) {
        BakedFile& file = files[first + i];
        if (i < each * pages)
            file = pageFile(baked.lightmaps[i / each], i / each, i % each);
        else if ((i -= each * pages) < probes)
            file = {"probes", i == 0 ? kProbeFile : kProbeTreeFile,
                    encodeKtx2(i == 0 ? probeTexture(baked.probes) : probeTreeTexture(baked.probes, baked.scene.origin))};
        else if ((i -= probes) < cubes)
            file = {"reflections", numbered("reflection_", i, ".ktx2"),
                    encodeKtx2(reflectionTexture(baked.reflections[i], baked.scene.origin))};
        else
            file = {"voxels", "voxels.ktx2", encodeKtx2(voxelTexture(baked.voxels, baked.scene.origin))};
        advance(1);
    });
    return files;
}

std::uint64_t packedFiles(const Baked& baked, bool exrMasters)
{
    return (filesOfPage(baked) + (exrMasters ? 1 : 0)) * baked.lightmaps.size() + probeFiles(baked) + baked.reflections.size() +
           (baked.voxels.closed.empty() ? 0 : 1);
}

static void demandWhole(const Baked& baked)
{
    check(baked.places.empty() || baked.places.size() == baked.scene.objects.size(), "each object has a place");
    for (const LightmapPlace& place : baked.places) check(place.page < int(baked.lightmaps.size()), "a place names a page");
    for (const Lightmap& page : baked.lightmaps)
        check(page.texels.size() == std::size_t(page.width) * std::size_t(page.height) && page.valid.size() == page.texels.size(),
              "a page is whole");
    for (const Lightmap& page : baked.lightmaps)
        check(page.direction.size() == (filesOfPage(baked) == 3 ? page.texels.size() : 0), "all pages know the direction, or none");
    check(baked.probes.positions.size() == baked.probes.probes.size() && baked.probes.nodes.empty() == baked.probes.cells.empty(),
          "a tree of probes is whole");
}

std::filesystem::path bakedPlace(const std::filesystem::path& directory)
{
    const std::filesystem::path place = placeOf(directory);
    std::error_code none;
    if (!std::filesystem::exists(place, none)) return place;
    const bool isFolder = std::filesystem::is_directory(place, none);
    if (isFolder && std::filesystem::is_empty(place, none)) return place;
    const std::optional<std::set<std::string>> ours = isFolder ? ownFiles(place) : std::nullopt;
    if (!ours && isBaked(place))
        throw Error("cannot write " + place.string() + ": its bake.json is damaged or not that of a bake; remove " + place.string() +
                    " and bake the level again, or name another folder");
    if (!ours) throw Error("cannot write " + place.string() + ": it exists and is not a bake; name another folder, or remove it first");
    // The bake takes the whole folder's place: what it would take along must be a bake's
    for (const auto& entry : std::filesystem::directory_iterator(place, none))
        if (!ours->contains(entry.path().filename().string()))
            throw Error("cannot write " + place.string() + ": beside a bake it holds " + entry.path().filename().string() +
                        ", which would be lost; move that away, or name another folder");
    return place;
}

// All files into the folder that is being built; what fails is told with the name that the folder will have.
static void fill(const Scaffold& scaffold, const std::vector<BakedFile>& files, json& manifest, const Baked& baked, bool exrMasters,
                 const Advance& advance)
try {
    const std::filesystem::path& beside = scaffold.path();
    for (const BakedFile& file : files) {
        stopIfInterrupted();
        writeFile(beside / file.name, file.bytes.data(), file.bytes.size());
    }
    for (std::size_t i = 0; exrMasters && i < baked.lightmaps.size(); ++i) {
        stopIfInterrupted();
        const std::string name = numbered("lightmap_", i, ".exr");
        writeExr(beside / name, lightmapImage(baked.lightmaps[i]));
        const std::vector<std::uint8_t> bytes = readFile(beside / name);
        manifest["products"]["lightmaps"]["masters"].push_back(name);
        manifest["sha256"][name] = sha256(bytes.data(), bytes.size());
        advance(1);
    }
    writeText(beside / "bake.json", manifest.dump(2, ' ', /* ensure_ascii= */ false, json::error_handler_t::replace) + "\n");
} catch (const Error& error) {
    throw Error(scaffold.told(error.what()), error.exit);
}

void writeBaked(const std::filesystem::path& directory, const Baked& baked, json manifest, bool exrMasters, const Advance& advance)
{
    demandWhole(baked);
    const std::filesystem::path to = bakedPlace(directory);
    const std::vector<BakedFile> files = productsOf(baked, advance);
    completeManifest(manifest, baked, files);
    try {
        Scaffold scaffold(to, Scaffold::Kind::folder);
        fill(scaffold, files, manifest, baked, exrMasters, advance);
        scaffold.takePlace();
    } catch (const std::filesystem::filesystem_error& failure) {
        throw Error("cannot write " + to.string() + ": " + failure.code().message());
    }
}

// ---- Reading ------------------------------------------------------------------------------------------------------------------------

Baked readBaked(const std::filesystem::path& directory)
{
    const json manifest = readManifest(directory);
    const auto texture = [&](const std::string& name) {
        return decodeKtx2(readBakedFile(manifest, directory, name), (directory / name).string());
    };
    const auto path = [&](const std::string& name) { return (directory / name).string(); };

    Baked baked;
    for (const std::string& name : productFiles(manifest, "scene", "", directory))
        readBakedFile(manifest, directory, name); // are they whole?
    readScene(directory / "scene.glb", baked);
    if (manifest.contains("level") && manifest["level"].is_object() && manifest["level"].contains("path") &&
        manifest["level"]["path"].is_string())
        baked.scene.path = manifest["level"]["path"].get<std::string>(); // the level is called what it was called
    baked.directAll = manifest.contains("direct") && manifest["direct"] == "all";

    const std::vector<std::string> names = productFiles(manifest, "lightmaps", ".ktx2", directory);
    const bool directional = std::any_of(names.begin(), names.end(), [](const std::string& name) { return name.ends_with(kDirectionEnd); });
    for (const std::string& name : names) {
        if (name.ends_with(kCoverageEnd) || name.ends_with(kDirectionEnd)) continue;
        const std::string page = name.substr(0, name.size() - std::string(".ktx2").size());
        baked.lightmaps.push_back(readLightmap(texture(name), texture(page + kCoverageEnd), path(name)));
        if (directional) readDirection(texture(page + kDirectionEnd), baked.lightmaps.back(), path(page + kDirectionEnd));
    }
    if (const std::vector<std::string> files = productFiles(manifest, "probes", ".ktx2", directory); !files.empty()) {
        if (std::find(files.begin(), files.end(), kProbeTreeFile) == files.end())
            throw Error("cannot read " + path(files[0]) + ": its probes are an older version's; bake again");
        baked.probes = readProbes(texture(kProbeFile), texture(kProbeTreeFile), path(kProbeFile), baked.scene.origin);
    }
    for (const std::string& name : productFiles(manifest, "reflections", ".ktx2", directory))
        baked.reflections.push_back(readReflection(texture(name), path(name), baked.scene.origin));
    for (const std::string& name : productFiles(manifest, "voxels", ".ktx2", directory))
        baked.voxels = readVoxels(texture(name), path(name), baked.scene.origin);
    for (const LightmapPlace& place : baked.places)
        if (place.page >= int(baked.lightmaps.size()))
            throw Error("cannot read " + path("scene.glb") + ": it names lightmap page " + std::to_string(place.page) + " and there are " +
                        std::to_string(baked.lightmaps.size()));
    return baked;
}

bool isBaked(const std::filesystem::path& path)
{
    std::error_code ignored;
    return std::filesystem::is_regular_file(path / "bake.json", ignored);
}
}
