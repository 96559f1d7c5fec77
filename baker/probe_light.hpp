// The light that meets a point of free space from everywhere.
#pragma once
#include "baker/context.hpp"
#include "shaders/probe.h"

namespace afterglow
{
struct ProbeLight {
    Sh9 half[2] = {shZero(), shZero()}; // irradiance / pi, from two independent halves of the paths
    vec3 lobe{0.0f}, toward{0.0f};      // as Probe's, from both
    float clearance = 0.0f;             // m, harmonic mean distance to what its rays meet

    Probe probe() const;
    float difference() const; // relative error of the irradiance, as the halves differ
};

// `samples` paths from a point, and up to `most` where they differ, of the random numbers of `seed`.
ProbeLight probeLight(BakeContext& context, vec3 position, uint seed, int samples, int most, RayCount& rays);
}
