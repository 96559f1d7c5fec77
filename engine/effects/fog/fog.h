// Fog: light scattered once toward the eye by homogeneous media, each filling a convex body.
#ifndef AFTERGLOW_FOG_H
#define AFTERGLOW_FOG_H
#include "shaders/medium.h"
#include "shaders/scene.h"
SHARED_BEGIN

struct FogParameters {
    uint steps;   // of the march, 1..256; four times as many count, for neighbours stand on different points of a step
    uint divisor; // the march runs at this fraction of the picture's resolution: 1, 2 or 4
};
FN FogParameters defaultFogParameters()
{
    FogParameters p;
    p.steps = 16u;
    p.divisor = 4u;
    return p;
}

struct FogFrame {
    mat4 clipToWorld;
    mat4 worldToClipBefore; // of the frame whose march is remembered
    vec4 eye;               // w = 1: position; 0: the direction towards an orthographic eye
    vec4 eyeBefore;
    vec3 ambient; // radiance from everywhere, where no probe says better
    uint steps;
    uint divisor;
    ivec2 size;  // of the picture, px
    float shift; // 0..1 of a step: where the march stands in this frame
    float share; // of this frame's march in what is remembered; 1: nothing is
    float texel; // edge of a texel of the march: m at 1 m from a perspective eye, m anywhere of an orthographic one
};

const uint kFogSunMaps = 0u;  // specialization constants; shadow maps of each sun, 0: nothing casts a shadow
const uint kFogProbes = 1u;   // 0: none
const uint kFogEmission = 2u; // some medium emits
const uint kFogMemory = 3u;   // the frames before count
const uint kFogLights = 4u;
const uint kFogMedia = 5u;

const uint kFogSurroundings = 4u; // steps through the light from everywhere, which varies slowly

// A ray that leaves to the sky ends where a medium has swallowed all but exp(-12) of what lies behind: less than half a step of 8 bits.
const float kFogOpaque = 12.0f;
const float kFogBlack = 80.0f; // optical depth beyond which nothing is told apart: exp(-80) is the last that is no denormal float

const float kFogRounding = 5e-7f; // relative, of a position by two float operations

// Where in a step (0..1) the share `within` of its light lies before, when the optical depth grows by x along it: to the first order in x.
FN float shareOfStep(float x, float within) { return within * (1.0f - 0.5f * clamp(x, -2.0f, 2.0f) * (1.0f - within)); }

// Frames that the march remembers: while the eye moves few enough that what was wrong fades within a second, while it is still all shifts.
const uint kFogRemembered = 8u;
const uint kFogRememberedStill = 64u;
const float kFogSameSurface = 0.1f; // relative distance by which a remembered texel may miss the surface of today's

// The distance at which a span is opaque in every channel that it dims, or its end.
FN float opaqueEnd(Span s, vec3 sigmaT)
{
    float least = kFloatMax;
    for (int c = 0; c < 3; ++c)
        if (sigmaT[c] > 0.0f) least = min(least, sigmaT[c]);
    return least < kFloatMax ? min(s.end, s.begin + kFogOpaque / least) : s.end;
}

// Where a frame's march stands, in steps: texels take turns at the quarters of a step that they share, and all move within a quarter by the
// golden ratio, whose any run of members is spread evenly about 0.
FN float fogShift(uint frame)
{
    const float kGolden = 0.618034f;
    uint n = frame % kFogRememberedStill;
    float quarter = float(((n & 1u) << 1u) | ((n >> 1u) & 1u));
    return 0.25f * (quarter + fract(0.5f + float(n) * kGolden) - 0.5f);
}

// A march about a point light, in equal steps of the angle under which the light sees them (Kulla & Fajardo 2012): 1/r^2 is 1 / (h^2 (1 +
// x^2)), so that a step of angle `step_` adds step_ / h of it, exactly. From the foot of the perpendicular t = along + h tan(angle).
struct LampMarch {
    float along; // m along the ray to the foot
    float h;     // m beside it
    float first; // angle at the begin of the span
    float step_;
};
FN LampMarch lampMarch(vec3 origin, vec3 direction, Span span, vec3 position, float nearest, float steps)
{
    vec3 offset = position - origin;
    LampMarch m;
    m.along = dot(offset, direction);
    vec3 beside = offset - direction * m.along;
    m.h = max(length(beside), nearest);
    float x0 = span.begin - m.along, x1 = span.end - m.along;
    m.first = atan(x0 / m.h);
    // The difference of two arcs as one: no cancellation when the lamp is far
    m.step_ = atan(m.h * (x1 - x0), m.h * m.h + x0 * x1) / steps;
    return m;
}

// Light of a sphere of radius r > 0 and intensity 1 from all sides, at d from its middle: radiance 1 / (pi r^2) over the solid angle that
// it fills, all of it inside; 1 / d^2 far away.
FN float sphereFluence(float r, float d)
{
    if (d <= r) return 4.0f / (r * r);
    return 2.0f / (d * d * (1.0f + sqrt(1.0f - r * r / (d * d))));
}
// Mean cosine between its directions and that of its middle: the first moment of a phase function, averaged over the sphere, is g times it.
FN float sphereMeanCosine(float r, float d) { return d <= r ? 0.0f : 0.5f * (1.0f + sqrt(1.0f - r * r / (d * d))); }

SHARED_END
#endif
