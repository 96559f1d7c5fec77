// A folder of shaders that one test writes, edits and leaves.
#pragma once
#include "engine/core/file.hpp"
#include <cstdlib>
#include <filesystem>
#include <string>
#include <unistd.h>

namespace afterglow
{
class Scratch
{
public:
    Scratch()
    {
        root = std::filesystem::temp_directory_path() / ("afterglow-shaders-" + std::to_string(getpid()));
        std::filesystem::create_directories(root);
    }
    ~Scratch() { std::filesystem::remove_all(root); }
    void write(const std::string& name, const std::string& text) const
    {
        std::filesystem::create_directories((root / name).parent_path());
        writeText(root / name, text);
    }
    std::filesystem::path root;
};
}
