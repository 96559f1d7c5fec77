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
    uint rays;          // by ray query: to a light that has a size, 4..64, a multiple of 4; one to a light that has none
    uint denoise;       // 1: the noise that those leave is filtered; in a frame the plan says so
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
    p.rays = 16u;
    p.denoise = 0u;
    return p;
}

// What the pass that traces shadows knows; the light at `first` and three more are its own.
struct ShadowTrace {
    mat4 clipToWorld;
    vec4 eye; // as View::eye
    uint first;
    uint lights; // of the level
    uint rays;   // ShadowParameters
    uint seed;
};

// Specialization constant: the noise of the shares is told, too, and sixteen neighbours share a sequence.
const uint kShadowNoise = 0u;

// Rays to a light are stratified: they scatter by less than the variance among them says. Experiment: of 0.3, 0.5, 0.8 and 1.3 the least
// error of 4 to 16 rays on the blocks of the test.
const float kStratified = 0.5f;

// What the filter of the shares knows of the picture.
struct ShadowDenoise {
    vec2 metres;  // as depthApart() takes them
    float pixel;  // m, of a pixel at the depth of 1 m, or of an orthographic one
    float frames; // that the picture is the mean of
};

// The rays to a light of some size that are traced first: one in each quarter of it. Where they agree, and with those of the pixels beside
// and above or below, the rest are spared.
const uint kFirstShadowRays = 4u;

SHARED_END
#endif
