// Whole files, read and written in one step.
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
void writeFile(const std::filesystem::path& path, const void* data, std::size_t size); // beside, then in place (scaffold.hpp)
void writeText(const std::filesystem::path& path, std::string_view text);

// The name under which a folder can be made and renamed: absolute, with no `.`, `..` or slash at its end.
std::filesystem::path withoutSlash(const std::filesystem::path& folder);

// Throws Error when nothing could be written at `path`: asked before long work, so that none is lost. Leaves nothing behind.
void requireWritable(const std::filesystem::path& path);

// Lower-case hexadecimal SHA-256 of the bytes.
std::string sha256(const void* data, std::size_t size);
}
