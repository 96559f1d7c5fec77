// Shadow maps: what a draw pushes, and the sizes.
#ifndef AFTERGLOW_SHADOW_EFFECT_H
#define AFTERGLOW_SHADOW_EFFECT_H
#include "shaders/shadow_map.h"
SHARED_BEGIN

struct ShadowPush {
    mat4 objectToClip;
    uint material; // masked casters only
};

struct ShadowParameters {
    uint sunTexels;    // edge of a directional light's map, 512..8192
    uint spotTexels;   // of a spot light's
    uint faceTexels;   // of one of the six faces of a point light's
    float slopeTexels; // how far a caster is pushed back, in texels times its slope
};

FN ShadowParameters defaultShadowParameters()
{
    ShadowParameters p;
    p.sunTexels = 2048u;
    p.spotTexels = 1024u;
    p.faceTexels = 512u;
    // Depth slope per texel counts the steeper axis; a diagonal slope is twice as steep over the diagonal of the filter: shadowBias
    p.slopeTexels = 2.0f * kShadowRadius;
    return p;
}

SHARED_END
#endif
