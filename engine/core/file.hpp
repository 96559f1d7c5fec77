// Whole files, and the way in which nothing is lost: write beside, then rename.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace afterglow
{
// Throws Error with the path and the system's reason.
std::vector<std::uint8_t> readFile(const std::filesystem::path& path);
std::string readText(const std::filesystem::path& path);
void writeFile(const std::filesystem::path& path, const void* data, std::size_t size); // to path.tmp, then renamed
void writeText(const std::filesystem::path& path, std::string_view text);

// The second half of writing beside: renames a finished file, or removes it and throws.
void moveIntoPlace(const std::filesystem::path& from, const std::filesystem::path& to);

// The same for a folder: `to` is the old folder until it is the new one, with no moment between. What was there before is then at `from`.
void exchangeFolders(const std::filesystem::path& from, const std::filesystem::path& to);

// Makes the folders above `path`, and throws Error when nothing could be written there: asked before long work, so that none is lost.
void requireWritable(const std::filesystem::path& path);

// Lower-case hexadecimal SHA-256 of the bytes.
std::string sha256(const void* data, std::size_t size);
}
