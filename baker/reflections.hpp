// Reflection probes: what a mirror would see from a few well-chosen points, blurred by GGX from mip to mip.
#pragma once
#include "baker/probes.hpp"
#include "engine/baked/baked.hpp"

namespace afterglow
{
// The probes that the level asks for; otherwise up to `most` of the irradiance probes, those with the widest view first and far from
// one another. Their proxy boxes reach the walls around them.
std::vector<ReflectionProbe> placeReflections(const World& world, const ProbesResult& probes, int most);

// Fills the probes: radiance path traced into faces of `size` texels, `samples` paths each, then prefiltered.
// Returns the relative RMSE of a texel of mip 0, from two independent halves of its samples.
float bakeReflections(BakeContext& context, std::vector<ReflectionProbe>& probes, int size, int samples);
}
