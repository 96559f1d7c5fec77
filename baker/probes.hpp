// Irradiance probes: where they stand, and the light that meets them from everywhere, as SH order 2.
#pragma once
#include "baker/lightmap.hpp"

namespace afterglow
{
// The volumes that the level asks for; one over its static bounds when it asks for none. Counts and places, no light yet.
std::vector<ProbeVolume> placeProbes(const Scene& scene, float spacing);

struct ProbesResult {
    std::vector<ProbeVolume> volumes;
    std::uint64_t count = 0, valid = 0;
    float estimatedError = 0.0f;  // relative RMSE of a probe's mean irradiance, from two independent halves of its rays
    std::vector<float> clearance; // m, per probe of all volumes in order: harmonic mean distance to what it sees; 0: invalid
};
ProbesResult bakeProbes(BakeContext& context, std::vector<ProbeVolume> volumes, int samples);

vec3 probePosition(const ProbeVolume& volume, int index); // world, m
}
