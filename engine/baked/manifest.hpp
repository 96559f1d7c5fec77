// bake.json, the contents page of a baked folder: what was baked from what, which files hold it, and what each of them weighs.
// Products lists, by kind, `files` (names in this folder) and `bytes`; `sha256` names every file's bytes.
#pragma once
#include "engine/baked/baked.hpp"
#include <optional>
#include <set>

namespace afterglow
{
constexpr int kBakeSchema = 1;

// One file of the folder, in memory.
struct BakedFile {
    std::string product; // scene, lightmaps, probes, reflections, voxels: whose `files` it is in
    std::string name;
    std::vector<std::uint8_t> bytes;
};

// Adds to what the baker said: schema, level, files, bytes, counts, checksums.
void completeManifest(nlohmann::json& manifest, const Baked& baked, const std::vector<BakedFile>& files);

// Reads and checks bake.json. Throws Error.
nlohmann::json readManifest(const std::filesystem::path& directory);

// bake.json and every file that it lists; nothing when the folder's bake.json is not one that this program wrote, of whatever version.
std::optional<std::set<std::string>> ownFiles(const std::filesystem::path& directory);

// The names of a product's files whose suffix it is, in order; none when the product is not there. Throws Error for a name that is no
// plain name.
std::vector<std::string> productFiles(const nlohmann::json& manifest, const std::string& product, const std::string& suffix,
                                      const std::filesystem::path& directory);

// Reads a file of the folder. Throws Error when it is missing or has not the bytes that the manifest says.
std::vector<std::uint8_t> readBakedFile(const nlohmann::json& manifest, const std::filesystem::path& directory, const std::string& name);
}
