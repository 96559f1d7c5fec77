// Reflection probes: what a mirror would see from a few well-chosen points, blurred by GGX from mip to mip.
#pragma once
#include "baker/context.hpp"
#include "engine/baked/baked.hpp"

namespace afterglow
{
// Fills the probes: radiance path traced into faces of `size` texels, `samples` paths each, then prefiltered.
// Returns the relative RMSE of a texel of mip 0, from two independent halves of its samples.
float bakeReflections(BakeContext& context, std::vector<ReflectionProbe>& probes, int size, int samples);
}
