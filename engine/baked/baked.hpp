// The baked level in memory, and its folder on disk (design.md, "The baked level"): each product's reader stands beside its writer.
#pragma once
#include "engine/baked/probe_tree.hpp"
#include "engine/core/image.hpp"
#include "engine/core/progress.hpp"
#include "engine/scene/voxels.hpp"
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace afterglow
{
// Irradiance / pi per texel, linear Rec.709; `valid` is the coverage, apart from colour (black stays black, no data stays no data).
struct Lightmap {
    int width = 0;
    int height = 0;
    std::vector<vec3> texels;
    std::vector<std::uint8_t> valid; // 1: baked, 2: dilated from baked neighbours, 0: outside every chart
    std::vector<vec4> direction;     // where the light of each texel comes from (shaders/lightmap.h); empty: flat alone
};

// Where an object's uv1 lies: page uv = uv1 * scale + offset; page -1: the object has no lightmap.
struct LightmapPlace {
    int page = -1;
    vec2 scale{1.0f};
    vec2 offset{0.0f};
};

// Prefiltered radiance: mip m of faces +x -x +y -y +z -z holds GGX of roughness reflectionRoughness(m) (shaders/reflection.h).
struct ReflectionProbe {
    std::string name;
    vec3 position{0.0f};
    vec3 boxLower{0.0f}, boxUpper{0.0f}; // world, proxy of the parallax correction
    int size = 0;                        // face edge of mip 0
    std::vector<std::vector<vec3>> mips; // per mip: 6 * edge * edge texels
};

// One level of detail of a mesh's primitive: indices into the primitive's vertices, and the errors that it commits.
struct LodLevel {
    std::vector<uint> indices;
    float error = 0.0f; // m, object space: how far it strays at most
    float turn = 0.0f;  // radians: how its normals turn, root mean square over its area
};
struct MeshLods {
    std::vector<std::vector<LodLevel>> primitives; // per primitive: levels, finest excluded
};

struct Baked {
    Scene scene;                       // with the atlas's uv1 in its vertices
    std::vector<LightmapPlace> places; // one per object
    std::vector<Lightmap> lightmaps;
    ProbeTree probes;
    std::vector<ReflectionProbe> reflections;
    std::vector<MeshLods> lods; // one per mesh
    VoxelGrid voxels;           // of the static objects; empty unless the level calls for them
    bool directAll = false;     // --direct all: the runtime adds no direct light
};

// Where the folder will stand, without a final slash. Throws Error when something does already that is neither empty nor a bake.
std::filesystem::path bakedPlace(const std::filesystem::path& directory);

// Writes the folder beside `directory` and renames it into place: complete or not at all. `manifest` becomes bake.json (products' files
// and bytes are filled in here). Throws Error when it cannot be written.
void writeBaked(const std::filesystem::path& directory, const Baked& baked, nlohmann::json manifest, bool exrMasters,
                const Advance& advance = unheard); // in packedFiles()

std::uint64_t packedFiles(const Baked& baked, bool exrMasters); // those that take a while

// Reads a folder. Throws Error when it is not a bake, or one of its files is foreign, truncated, or of another version.
Baked readBaked(const std::filesystem::path& directory);

// True when the path is a folder that holds bake.json: `afterglow render LEVEL|DIR` asks.
bool isBaked(const std::filesystem::path& path);
}
