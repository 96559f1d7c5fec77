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
void writeFile(const std::filesystem::path& path, const void* data,
               std::size_t size); // beside, then in place (scaffold.hpp); straight into a device or a pipe
void writeText(const std::filesystem::path& path, std::string_view text);

// Throws Error when no file (or no folder) could be written at `path`: asked before long work, so that none is lost. Leaves nothing behind.
void requireWritable(const std::filesystem::path& path);
void requireWritableFolder(const std::filesystem::path& path);

struct NamedFile {
    std::string word; // before it on the command line
    std::filesystem::path path;
};

// Throws Error (Exit::usage) when an output would take the place of another output or of an input, links followed. No name is no output,
// and a device or a pipe takes no place.
void requireApart(const std::vector<NamedFile>& outputs, const std::vector<NamedFile>& inputs);

// Throws Error (Exit::usage) when the output's name ends in none of them, in capitals or not.
void requireEnding(const std::filesystem::path& output, const std::vector<std::string>& endings);

// What the name ends in, in lower case: `.png`, also of a .PNG.
std::string suffix(const std::filesystem::path& path);

// Lower-case hexadecimal SHA-256 of the bytes.
std::string sha256(const void* data, std::size_t size);
}
