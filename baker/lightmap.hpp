// Fills the lightmap pages: irradiance / pi per texel by path tracing, tile by tile.
#pragma once
#include "baker/context.hpp"
#include "baker/islands.hpp"
#include "baker/texels.hpp"

namespace afterglow
{
// How long a lightmap is traced: a number of paths for each texel, or as many as an error asks for, more of them where there is more noise.
struct LightmapEffort {
    int samples = 0;
    std::optional<float> targetError; // of estimatedError; samples are not asked then
};

struct LightmapResult {
    std::uint64_t texels = 0, validTexels = 0;
    double samples = 0.0;        // paths of a valid texel, on average, of all layers of light
    double kept = 0.0;           // of the texels, the share that an earlier bake has traced
    float estimatedError = 0.0f; // relative RMSE of a texel, from two halves of its samples, before any denoising; 0 where there is one
};

// Takes a page, not dilated, when all of them have their light: one after the other, so that their guides are never there together.
using TakePage = std::function<void(Lightmap page, TexelGuides& guides)>;
LightmapResult bakeLightmaps(BakeContext& context, const std::vector<LightmapPlace>& places, const std::vector<ivec2>& pageSizes,
                             const LightmapEffort& effort, const TakePage& take);

// The light of these places by `samples` paths of each texel, for later stages to look up where no lightmap is made.
void learnLight(BakeContext& context, const std::vector<LightmapPlace>& places, const std::vector<ivec2>& pageSizes, int samples);
}
