// What a bake holds in memory, and what of it has to wait on the disk so that all stays below --max-memory.
#pragma once
#include "baker/world.hpp"
#include <nlohmann/json_fwd.hpp>
#include <optional>

namespace afterglow
{
// What is going to be made.
struct BakeSizes {
    std::vector<ivec2> pages; // texels, of lightmaps
    bool directional = false;
    bool caches = false;          // paths end where light is known
    bool written = true;          // pages are filled; false: their light is there for a cache alone
    std::size_t layers = 1;       // of light; the light of more than one waits on the disk in any case
    std::uint64_t seamPoints = 0; // that are stitched
    std::uint64_t triangles = 0;  // that get levels of detail
    std::uint64_t parted = 0;     // that part space, for irradiance probes; what probes take, bakeProbes() watches itself
    std::uint64_t cubeTexels = 0; // of all faces of all reflection probes
    bool voxels = false;
    int threads = 0; // that trace
};

// Bytes beside the level and its tree.
struct BakeMemory {
    std::uint64_t threads = 0; // their stacks, and what the allocator keeps for each
    std::uint64_t light = 0;   // what the paths have brought so far: it may wait on the disk, tile by tile
    std::uint64_t pages = 0;   // until they are written, and whose their texels are
    std::uint64_t work = 0;    // of filtering one page, of stitching, or of packing one page by each core: the greatest
    std::uint64_t later = 0;   // of the stages that come after the lightmaps
};
BakeMemory memoryOf(const BakeSizes& sizes);

// Of the process, the level and its tree included, before the first path.
struct ProcessMemory {
    std::uint64_t now = 0, peak = 0; // bytes
};

struct MemoryPlan {
    bool streamed = false;      // light waits on the disk
    std::uint64_t expected = 0; // bytes of the process, at most
};

// Bytes that one run of a bake holds and another does not: a bound that is named must do again.
constexpr std::uint64_t kUneven = 2 << 20;

// Throws Error when not even streamed light leaves enough of `bound` (bytes), with the least that does. `hasDisk`: there is a journal.
MemoryPlan planMemory(const BakeMemory& needed, const ProcessMemory& held, std::optional<std::uint64_t> bound, bool hasDisk);

// What bake.json says of it; the peak is known last.
nlohmann::json told(const BakeMemory& needed, const MemoryPlan& plan, const std::vector<ivec2>& pages, const World& world);
}
