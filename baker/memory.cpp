#include <fmt/format.h> // first: it has a member called `check`, as error.hpp has a macro

#include "baker/memory.hpp"
#include "baker/tile_light.hpp"
#include "engine/core/error.hpp"
#include "engine/core/jobs.hpp"
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

// Bytes of a texel
static constexpr std::uint64_t kPage = sizeof(vec3) + sizeof(std::uint8_t), kDirection = sizeof(vec4), kOwner = sizeof(uint);
static constexpr std::uint64_t kCache =
    (2 * 2 + 2) * sizeof(vec3); // of both halves; one that is asked, and one that is filled, with its places
static constexpr std::uint64_t kCachedDirection = 2 * 2 * sizeof(vec4);
static constexpr std::uint64_t kGuides = 3 * sizeof(vec3) + sizeof(float);
static constexpr std::uint64_t kFilter = 160; // what denoise() has beside the page
static constexpr std::uint64_t kPacking =
    4 * sizeof(vec4); // by each core, of light that is too bright for less: plain, packed, compressed, in a file
static constexpr std::uint64_t kPacked = 4 + 1, kPackedDirection = 8; // in files that wait to be written
static constexpr std::uint64_t kStitch =
    1024; // of a seam's point, at most: its lookups and its share of the equations, were all seams one patch
static constexpr std::uint64_t kTiles = 7; // tiles, their triangles, their places in the journal: 436 bytes a tile

// Of one mesh of 160 000 triangles 614 bytes each were measured; of the finest voxels of the gallery 26 MB.
static constexpr std::uint64_t kLods = 640, kVoxels = 28 << 20, kParted = 192;
static constexpr std::uint64_t kCube = 2 * sizeof(vec3); // with its mips, and what they are filtered from

static constexpr std::uint64_t kThread = 256 << 10; // of sixteen threads that light Cornell's probes 220 KB each were measured

static constexpr double kMargin = 0.1; // of what is added: what the allocator keeps to itself

BakeMemory memoryOf(const BakeSizes& sizes)
{
    std::uint64_t texels = 0, largest = 0; // of all pages, of one
    for (ivec2 size : sizes.pages) {
        const std::uint64_t own = std::uint64_t(size.x) * std::uint64_t(size.y);
        texels += own;
        largest = std::max(largest, own);
    }
    const std::uint64_t direction = sizes.directional ? kDirection : 0, packed = kPacked + (sizes.directional ? kPackedDirection : 0);
    const std::uint64_t files = std::min(std::uint64_t(threadCount(0)), std::uint64_t(sizes.directional ? 3 : 2) * sizes.pages.size());
    const std::uint64_t cache = sizes.caches ? kCache + (sizes.directional ? kCachedDirection : 0) : 0,
                        page = sizes.written ? kPage + direction + kOwner : 0;
    return {.threads = std::uint64_t(sizes.threads) * kThread,
            .light = sizes.layers > 1 ? 0 : texels * sizeof(TexelLight),
            .pages = texels * (page + sizes.layers * kTiles + cache),
            .work = sizes.written ? std::max({largest * (kGuides + kFilter + direction), sizes.seamPoints * kStitch,
                                              texels * packed + files * largest * kPacking})
                                  : 0,
            .later = sizes.cubeTexels * kCube + std::max({sizes.triangles * kLods, sizes.parted * kParted, sizes.voxels ? kVoxels : 0})};
}

MemoryPlan planMemory(const BakeMemory& needed, const ProcessMemory& held, std::optional<std::uint64_t> bound, bool hasDisk)
{
    const auto with = [&](std::uint64_t light) {
        const std::uint64_t added = needed.threads + needed.pages + std::max(light + needed.work, needed.later);
        return std::max(held.now + added + std::uint64_t(kMargin * double(added)), held.peak);
    };
    const std::uint64_t streamed = with(0), whole = with(needed.light);
    if (!bound || whole <= *bound) return {false, whole};
    const std::uint64_t least = hasDisk ? streamed : whole;
    const auto mebibytes = [](std::uint64_t bytes) { return std::uint64_t(std::ceil(double(bytes) / (1 << 20))); };
    if (least > *bound)
        throw Error(
            fmt::format("--max-memory {}M does not hold this bake: the level, its atlas and its tree took {} MiB before the first path; "
                        "all of it needs {}M",
                        *bound >> 20, mebibytes(held.peak), mebibytes(least + kUneven)),
            Exit::usage);
    return {true, streamed};
}

json told(const BakeMemory& needed, const MemoryPlan& plan, const std::vector<ivec2>& pages, const World& world)
{
    double texels = 0.0;
    for (ivec2 size : pages) texels += double(size.x) * double(size.y);
    const Scene& scene = world.scene();
    const double level = double(scene.vertices.size() * sizeof scene.vertices[0] + scene.indices.size() * sizeof scene.indices[0]);
    const auto held = double(needed.pages + needed.work + (plan.streamed ? 0 : needed.light));
    return {{"expected_bytes", plan.expected},
            {"texel_bytes", texels > 0.0 ? held / texels : 0.0},
            {"triangle_bytes", (level + double(world.bytes())) / std::max(double(world.triangles().size()), 1.0)},
            {"streamed_bytes", plan.streamed ? needed.light : 0}};
}
}
