// The baker's contents page: what it can make of a level. Offline: no Vulkan below this line.
#pragma once
#include "engine/baked/baked.hpp"
#include "engine/core/progress.hpp"
#include "engine/scene/scene.hpp"
#include <array>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

namespace afterglow
{
enum class Quality { draft, medium, high };
enum class Denoiser { none, builtin, oidn }; // oidn: baker/oidn.hpp
const char* nameOf(Quality quality);
const char* nameOf(Denoiser denoiser);

// The least cap of bounces beside a light cache, whose light may have met as many surfaces before.
constexpr int kCachedBounces = 8;

// Paths per texel that a quality stands for.
int samplesOf(Quality quality);

// Noise of lookups where so much is asked for between probes: both together err by a twelfth more than that.
float probeNoiseFor(float between);

// What `afterglow bake` may ask for; absent values follow from the quality.
struct BakeOptions {
    Quality quality = Quality::medium;
    std::optional<float> texelsPerMetre;
    std::optional<int> lightmapPages;        // so many are filled: their density follows, and what is said of it only weighs objects
    std::optional<int> samples;              // paths per texel
    std::optional<float> targetError;        // relative RMSE of a texel: as many paths as that takes, in the place of `samples`
    std::optional<int> bounces;              // surfaces that scatter
    std::optional<float> probeSpacing;       // m, of the largest cells
    std::optional<float> probeError;         // relative, between the probes: cells are cut until then; 0: as the spacing says
    std::optional<std::uint64_t> probeBytes; // or until the tree is as large
    std::optional<float> probeNoise;         // relative RMSE of lookups by noise: up to 32 times a probe's paths; probeNoiseFor()
    std::optional<int> probeSamples;         // paths per probe, at least
    int probeOrder = 2;                      // of the spherical harmonics of a probe, 1 or 2
    bool probeWalls = true;                  // false: a plain grid that reaches through walls, to compare with
    std::optional<int> reflectionSize;       // texels of a face's edge
    std::optional<int> reflectionSamples;    // paths per texel
    std::optional<bool> directional;         // lightmaps tell the normals of a normal map apart; absent: as the level calls for
    std::optional<bool> lightCache;          // paths end where light is known (light_cache.hpp); absent: where a filter follows anyway
    std::uint32_t seed = 1;
    int threads = 0;                                                                      // 0: all cores
    std::optional<std::uint64_t> maxMemory;                                               // bytes of this process (memory.hpp)
    bool directAll = false;                                                               // --direct all: the direct part of every light
    bool lightmaps = true, probes = true, reflections = true, lods = true, voxels = true; // --only
    bool exr = false;
    bool lightLayers = false; // lightmaps of each light apart (light_layers.hpp): after a change of its strength and colour none is traced
    bool incremental = false; // of a level where something moved, lightmaps are traced where that reaches (reach.hpp)
    bool keeps() const { return lightLayers || incremental; } // what is traced, for the next bake of the level
    Denoiser denoiser = Denoiser::builtin;                    // the stated error is that before it
    bool stitch = true;                                       // charts agree where one surface is cut (stitch.hpp)
    std::optional<double> timeBudget; // s, of bakeLevel(): it then chooses quality, at most what is said, and paths (pace.hpp)
    bool resume = false;              // of bakeLevel(): goes on with a bake that was killed (journal.hpp)
    bool force = false;               // of bakeLevel(): bakes also what stands there already
    // Whatever is added here and changes a bit of the result belongs into bakeKey(), too.
};

// With every value that is absent as the quality and the level's size say.
BakeOptions resolved(BakeOptions options, const Scene& scene);

// What bakeLevel() writes, in memory; `manifest` is told what bake.json says of it. With a journal, what that holds is not done again;
// nor is, with what an earlier bake has kept, what has not changed since.
class Journal;
Baked bakeScene(Scene scene, const BakeOptions& options, Progress& progress, nlohmann::json& manifest, Journal* journal = nullptr,
                const Journal* earlier = nullptr);

// Bakes the level into `directory`, complete or not at all (baker/bake.cpp has the order of the stages), with a journal beside it.
// Throws Error; exit code 130 when interrupted.
void bakeLevel(const std::filesystem::path& level, const std::filesystem::path& directory, const BakeOptions& options, Progress& progress);

// How paths are traced: one after the other, or many stage by stage (waves.hpp). Of the same paths, up to rounding.
enum class Organisation { loop, wavefront };

// The picture with no shortcut: path traced, scene-linear radiance (or cosine-weighted visibility, `ao`).
struct TruthOptions {
    Camera camera;
    ivec2 size = kPictureSize;
    int samples = 64; // per pixel
    std::uint32_t seed = 1;
    int bounces = 64;
    int rouletteFrom = 4;                           // first bounce after which a path may end by chance
    int portalDepth = 1;                            // through how many portals the camera sees
    std::optional<int> scatterings;                 // in media, of one path; 1: single scattering
    Organisation organisation = Organisation::loop; // which wins: engine/effects/truth/README.md
    bool directOnly = false;                        // emission that the camera sees and light that reaches the first surface straight
    bool spectral = false;                          // paths of three wavelengths each, in place of three channels
    bool ao = false;                                // cosine-weighted visibility within aoRange
    float aoRange = 1.0f;                           // m
    int threads = 0;
};
Image truth(const Scene& scene, const TruthOptions& options, Progress& progress);

// Irradiance at points, path traced: about `normal`, or about +x -x +y -y +z -z.
struct ProbePoint {
    dvec3 position{0.0}; // m, in the level's own coordinates
    std::optional<vec3> normal;
};
struct PointIrradiance {
    std::array<vec3, 6> value{}; // irradiance E(n) = integral of L cos over the hemisphere; [0] alone when the point has a normal
    std::array<vec3, 6> error{}; // standard error of each
    float open = 1.0f;           // of one texel's area about a lightmapped point: the share that no solid covers
};
std::vector<PointIrradiance> probeTruth(const Scene& scene, const std::vector<ProbePoint>& points, int samples, std::uint32_t seed,
                                        int threads, Progress& progress);

// The same, read from a baked level: the lightmap of the surface there, or the irradiance probes. The lightmap answers with the mean over
// one texel's area about the point, in which what another solid covers counts as dark; value / open is what the runtime draws in the open
// part. Throws Error when neither knows a point.
std::vector<PointIrradiance> probeBaked(const Baked& baked, const std::vector<ProbePoint>& points);
}
