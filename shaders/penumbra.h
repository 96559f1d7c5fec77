// Soft and mapped shadows: the shapes that approximations are measured against.
#ifndef AFTERGLOW_PENUMBRA_H
#define AFTERGLOW_PENUMBRA_H
#include "shaders/constants.h"
SHARED_BEGIN

// Fraction of a uniform disc light that is visible past a straight edge, t radii beyond its centre: -1 all hidden, 1 all seen.
FN float penumbra(float t)
{
    float c = clamp(t, -1.0f, 1.0f);
    return 1.0f - (acos(c) - c * sqrt(max((1.0f - c) * (1.0f + c), 0.0f))) * kInvPi;
}

// Width of the penumbra of a light of diameter w: occluder and receiver at zb <= zr from the light. 0 at contact and without a blocker.
FN float penumbraWidth(float w, float zb, float zr) { return zb > 0.0f ? w * max(zr - zb, 0.0f) / zb : 0.0f; }

// Smallest offset along the light's direction that hides acne: a map of n texels over fov (radians), depth z, slope given by its tangent,
// filter radius k texels, one axis. An occluder nearer to its receiver than this casts no shadow.
FN float shadowBias(float fov, float n, float z, float slopeTangent, float k)
{
    return (k + 0.5f) * 2.0f * z * tan(0.5f * fov) / n * slopeTangent;
}

SHARED_END
#endif
