// The outside of a level: the chunks of a .glb, checked before anybody follows their lengths, and the folder that its URIs may not leave.
#include "engine/scene/document.hpp"
#include <algorithm>
#include <cstring>

namespace afterglow
{
namespace
{
constexpr std::size_t kHeaderBytes = 12; // magic, version, length of the file
constexpr std::size_t kChunkBytes = 8;   // length, type
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;

std::uint32_t word(const std::vector<std::uint8_t>& file, std::size_t offset) // little endian
{
    return std::uint32_t(file[offset]) | std::uint32_t(file[offset + 1]) << 8 | std::uint32_t(file[offset + 2]) << 16 |
           std::uint32_t(file[offset + 3]) << 24;
}

std::string percentDecoded(const std::string& uri)
{
    std::string path;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] == '%' && i + 2 < uri.size() && std::isxdigit(std::uint8_t(uri[i + 1])) && std::isxdigit(std::uint8_t(uri[i + 2]))) {
            path += char(std::stoi(uri.substr(i + 1, 2), nullptr, 16));
            i += 2;
        } else {
            path += uri[i];
        }
    }
    return path;
}
}

bool isBinary(const std::vector<std::uint8_t>& file) { return file.size() >= 4 && std::memcmp(file.data(), "glTF", 4) == 0; }

std::string jsonText(const std::vector<std::uint8_t>& file)
{
    if (!isBinary(file)) return {file.begin(), file.end()};
    if (file.size() < kHeaderBytes + kChunkBytes) throw Malformed("the file is truncated");
    if (word(file, 4) != 2) throw Malformed("the file is binary glTF of version " + std::to_string(word(file, 4)) + ", and 2 is read");
    const std::size_t length = word(file, 8);
    if (length > file.size())
        throw Malformed("the file is truncated: " + std::to_string(file.size()) + " of " + std::to_string(length) + " bytes are there");

    // Walk all chunks, so that no length in them points past the end.
    for (std::size_t offset = kHeaderBytes; offset < length;) {
        if (length - offset < kChunkBytes || length - offset - kChunkBytes < word(file, offset))
            throw Malformed("a chunk of the file is longer than the file");
        offset += kChunkBytes + word(file, offset);
    }
    if (length < kHeaderBytes + kChunkBytes || word(file, kHeaderBytes + 4) != kJsonChunk)
        throw Malformed("the file does not begin with a chunk of JSON");
    const auto text = file.begin() + kHeaderBytes + kChunkBytes;
    return {text, text + word(file, kHeaderBytes)};
}

std::filesystem::path besideLevel(const std::filesystem::path& level, const std::string& uri)
{
    const std::filesystem::path named = percentDecoded(uri);
    const std::filesystem::path folder = std::filesystem::weakly_canonical(std::filesystem::absolute(level).parent_path());
    const std::filesystem::path file = std::filesystem::weakly_canonical(folder / named);
    const std::filesystem::path inside = file.lexically_relative(folder);
    const bool climbs = std::find(named.begin(), named.end(), std::filesystem::path("..")) != named.end();
    if (named.is_absolute() || climbs || inside.empty() || *inside.begin() == "..")
        throw Malformed("\"" + uri + "\" leads out of the level's own folder; keep the level's files together");
    return file;
}
}
