// The light that meets a point of free space from everywhere.
#pragma once
#include "baker/context.hpp"
#include "baker/sphere_sums.hpp"
#include "shaders/probe.h"

namespace afterglow
{
struct ProbeLight {
    Sh9 half[2] = {shZero(), shZero()}; // irradiance / pi, from two independent halves of the paths
    vec3 lobe{0.0f}, toward{0.0f};      // as Probe's, from both

    Probe probe() const;
    void keep(int order);    // of what was found: of order 1 neither the second band nor a lobe
    double light() const;    // irradiance / pi, mean over all normals and channels
    double variance() const; // mean square that it errs by, as the halves differ
};

// Sums over the paths of one probe, in batches: a float that sums all paths one by one loses digits, and how batches vary tells their noise.
struct ProbeSums {
    uint seed = 0;                          // of its random numbers
    int batch = 1;                          // paths of one
    int batches = 0;                        // of each half, so far
    Sh9 radiance[2] = {shZero(), shZero()}; // of each half
    std::array<vec3, kSphereNormals> irradiance{};
    double squares[2] = {0.0, 0.0}; // of each half: of the batches' irradiance

    int paths() const { return 2 * batch * batches; }
    // As ProbeLight::variance(), but of the paths alone and not of the light that both halves look up; batches know less of how evenly
    // directions are spread than halves do, so that it is a bound.
    double variance() const;
};

// No paths yet; batches as suit `paths`.
ProbeSums noPaths(uint seed, int paths);

// Goes on until there are as many.
void tracePaths(BakeContext& context, vec3 position, int paths, RayCount& rays, ProbeSums& sums);

ProbeLight lightOf(const ProbeSums& sums);
}
