// Shadow maps: what a draw pushes, and the sizes.
#ifndef AFTERGLOW_SHADOW_EFFECT_H
#define AFTERGLOW_SHADOW_EFFECT_H
#include "shaders/shadow_map.h"
SHARED_BEGIN

struct ShadowPush {
    mat4 objectToClip;
    vec2 furthest; // that a caster is pushed back, in depth: x * depth + y
    uint material; // masked casters only
};

struct ShadowParameters {
    uint sunTexels;     // edge of a directional light's map, 512..8192
    uint spotTexels;    // of a spot light's
    uint faceTexels;    // of one of the six faces of a point light's
    uint cascadeTexels; // of a map that follows the eye under a sun
    float finestTexel;  // m, of the nearest of those
};

// A sun's map that resolves no more than this leaves jagged shadows before the eye: maps that follow the eye are called for.
const float kCoarseTexel = 0.02f; // m

FN ShadowParameters defaultShadowParameters()
{
    ShadowParameters p;
    p.sunTexels = 2048u;
    p.spotTexels = 1024u;
    p.faceTexels = 512u;
    p.cascadeTexels = 2048u;
    p.finestTexel = 0.01f;
    return p;
}

SHARED_END
#endif
