// Fog: light scattered once toward the eye by homogeneous media, each filling a box.
#ifndef AFTERGLOW_FOG_H
#define AFTERGLOW_FOG_H
#include "shaders/medium.h"
#include "shaders/scene.h"
SHARED_BEGIN

struct FogParameters {
    uint steps;   // of the march, 4..128; four times as many count, for neighbours stand on different points of a step
    uint divisor; // the march runs at this fraction of the picture's resolution: 1, 2 or 4
};
FN FogParameters defaultFogParameters()
{
    FogParameters p;
    p.steps = 16u;
    p.divisor = 2u;
    return p;
}

struct FogFrame {
    mat4 clipToWorld;
    vec4 eye;     // w = 1: position; 0: the direction towards an orthographic eye
    vec3 ambient; // radiance from everywhere, where no probe says better
    uint lights;
    uint media;
    uint probeBoxes;
    uint steps;
    uint divisor;
    ivec2 size; // of the picture, px
};

const uint kFogSunMaps = 0u; // specialization constants; shadow maps of each sun, 0: nothing casts a shadow
const uint kFogProbes = 1u;

const uint kFogSurroundings = 4u; // steps through the light from everywhere, which varies slowly

// A ray that leaves to the sky ends where a medium has swallowed all but exp(-12) of what lies behind: less than half a step of 8 bits.
const float kFogOpaque = 12.0f;

// The distance at which a span is opaque in every channel that it dims, or its end.
FN float opaqueEnd(Span s, vec3 sigmaT)
{
    float least = kFloatMax;
    for (int c = 0; c < 3; ++c)
        if (sigmaT[c] > 0.0f) least = min(least, sigmaT[c]);
    return least < kFloatMax ? min(s.end, s.begin + kFogOpaque / least) : s.end;
}

SHARED_END
#endif
