// A glTF file, opened: its JSON, and the bytes behind its URIs, read from the level's own folder downwards and from nowhere else.
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace afterglow
{
// Something in the file is not as glTF says. loadLevel() turns it into the one sentence of an Error that names the file.
class Malformed : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

struct Document {
    std::filesystem::path path;
    std::shared_ptr<const nlohmann::json> json; // checked: depth, version, required extensions
    std::vector<std::vector<std::uint8_t>> buffers;
    std::vector<std::vector<std::uint8_t>> images; // as files hold them (.png, .jpg); empty: not found, or in a buffer view
    std::vector<std::string> unread;               // extensions that the file uses, does not require, and that are not read here
};

// Reads .glb or .gltf. Throws Error when it cannot be read, Malformed when it is not glTF 2.0 or needs an extension that is not read here.
Document openDocument(const std::filesystem::path& path);

// The file that a level names by a relative URI, percent-decoded. Throws Malformed when it lies outside the level's folder, symbolic links
// followed; the file need not exist.
std::filesystem::path besideLevel(const std::filesystem::path& level, const std::string& uri);

// The JSON text of a .glb (its container checked: magic, version, chunk lengths) or of a .gltf.
std::string jsonText(const std::vector<std::uint8_t>& file);
bool isBinary(const std::vector<std::uint8_t>& file);
}
