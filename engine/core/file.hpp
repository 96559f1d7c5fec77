// Whole files, and the two ways in which nothing is lost: write beside and rename, and a folder that appears complete or not at all.
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

// Lower-case hexadecimal SHA-256 of the bytes.
std::string sha256(const void* data, std::size_t size);
}
