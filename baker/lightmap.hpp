// Fills the lightmap pages: irradiance / pi per texel by path tracing, tile by tile.
#pragma once
#include "baker/denoise.hpp"
#include "baker/solids.hpp"
#include "baker/texels.hpp"
#include "baker/tracer.hpp"
#include "engine/core/progress.hpp"

namespace afterglow
{
// What every stage of a bake shares.
struct BakeContext {
    const LightTransport& transport;
    Solids solids;
    std::vector<Light> direct; // lights whose direct part the bake holds
    std::uint32_t seed = 1;
    int threads = 0;
    Progress& progress;
    std::atomic<std::uint64_t> rays{0};

    BakeContext(const LightTransport& t, std::vector<Light> d, Progress& p) : transport(t), solids(t), direct(std::move(d)), progress(p) {}
};

// How long a lightmap is traced: a number of paths for each texel, or as many as an error asks for, more of them where there is more noise.
struct LightmapEffort {
    int samples = 0;
    std::optional<float> targetError; // of estimatedError; samples are not asked then
};

struct LightmapResult {
    std::vector<Lightmap> pages;     // not dilated
    std::vector<TexelGuides> guides; // one per page
    std::uint64_t texels = 0, validTexels = 0;
    double samples = 0.0;        // paths of a valid texel, on average
    float estimatedError = 0.0f; // relative RMSE of a texel, from two independent halves of its samples, before any denoising
};
LightmapResult bakeLightmaps(BakeContext& context, const std::vector<LightmapPlace>& places, const std::vector<ivec2>& pageSizes,
                             const LightmapEffort& effort);
}
