// Light that meets a point from everywhere, summed over paths.
#pragma once
#include "shaders/color.h"
#include "shaders/sampling.h"
#include "shaders/sh.h"
#include <array>
#include <cstddef>

namespace afterglow
{
using namespace shared;

constexpr float kGoldenAngle = 2.39996323f; // radians: a turn by (3 - sqrt 5) / 2

// Directions that are evenly spread over the sphere: a spiral of golden angles.
template <std::size_t kCount>
std::array<vec3, kCount> spiral()
{
    std::array<vec3, kCount> all;
    for (std::size_t i = 0; i < kCount; i++) {
        const float z = 1.0f - (2.0f * float(i) + 1.0f) / float(kCount), r = sqrt(max(1.0f - z * z, 0.0f)), turn = kGoldenAngle * float(i);
        all[i] = vec3(r * cos(turn), z, r * sin(turn));
    }
    return all;
}

constexpr std::size_t kSphereNormals = 64;
inline const std::array<vec3, kSphereNormals> kSphereNormal = spiral<kSphereNormals>();

struct SphereSums {
    Sh9 radiance = shZero();                  // its bands
    float irradiance[3][kSphereNormals] = {}; // / pi, by channel, about kSphereNormal

    void add(vec3 direction, vec3 value)
    {
        if (!(largestOf(value) > 0.0f)) return;
        shAdd(radiance, direction, value);
        for (std::size_t i = 0; i < kSphereNormals; i++) {
            const float cosine = max(dot(kSphereNormal[i], direction), 0.0f) * kInvPi;
            irradiance[0][i] += cosine * value.x;
            irradiance[1][i] += cosine * value.y;
            irradiance[2][i] += cosine * value.z;
        }
    }
};
}
