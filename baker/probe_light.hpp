// The light that meets a point of free space from everywhere.
#pragma once
#include "baker/context.hpp"
#include "shaders/probe.h"

namespace afterglow
{
struct ProbeLight {
    Sh9 half[2] = {shZero(), shZero()}; // irradiance / pi, from two independent halves of the paths
    vec3 lobe{0.0f}, toward{0.0f};      // as Probe's, from both
    int paths = 0;                      // of both

    Probe probe() const;
    void keep(int order);     // of what was found: of order 1 neither the second band nor a lobe
    float difference() const; // relative error of the irradiance, as the halves differ
};

// How long a probe is traced: `samples` paths, and up to `most` until their noise is no more than `noise`, relative. By how the paths vary:
// who stopped when two halves agree would stop by luck, and state too little. Noise of the light that they look up they cannot mend.
struct ProbePaths {
    int samples, most;
    float noise = 0.0f;
};

// The light at a point, by the random numbers of `seed`.
ProbeLight probeLight(BakeContext& context, vec3 position, uint seed, const ProbePaths& paths, RayCount& rays);
}
