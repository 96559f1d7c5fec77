// Bakes to be compared bit by bit, and a place of a test's own for them.
#pragma once
#include "baker/baker.hpp"
#include "engine/core/file.hpp"
#include <gtest/gtest.h>
#include <unistd.h>

namespace afterglow
{
using Contents = std::vector<std::uint8_t>;

// A folder of the test's and the process's own, and the place of a bake in it.
struct Ground {
    std::filesystem::path folder, place = folder / "level.baked", file = folder / "level.baked.journal";
    explicit Ground(const std::string& name)
        : folder(std::filesystem::path(testing::TempDir()) / ("journal_" + name + std::to_string(getpid())))
    {
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder);
    }
    ~Ground() { std::filesystem::remove_all(folder); }
    bool isEmpty() const { return std::filesystem::is_empty(folder); }
};

inline void overwrite(const std::filesystem::path& path, const Contents& bytes) { writeFile(path, bytes.data(), bytes.size()); }

// Bits of everything that a bake makes.
inline Contents bitsOf(const Baked& baked)
{
    Contents bytes;
    const auto add = [&](const auto& list) {
        const auto* from = reinterpret_cast<const std::uint8_t*>(list.data());
        bytes.insert(bytes.end(), from, from + list.size() * sizeof list[0]);
    };
    for (const Lightmap& page : baked.lightmaps) add(page.texels), add(page.valid), add(page.direction);
    add(baked.probes.probes), add(baked.probes.cells), add(baked.probes.nodes);
    for (const ReflectionProbe& probe : baked.reflections)
        for (const auto& mip : probe.mips) add(mip);
    for (const MeshLods& mesh : baked.lods)
        for (const auto& levels : mesh.primitives)
            for (const LodLevel& level : levels) add(level.indices);
    return bytes;
}
}
