// Reflection: what a glossy surface mirrors of the picture itself, or of the level by rays.
#ifndef AFTERGLOW_EFFECT_REFLECTION_H
#define AFTERGLOW_EFFECT_REFLECTION_H
#include "shaders/camera.h"
#include "shaders/reflection.h"
SHARED_BEGIN

struct ReflectionParameters {
    uint steps;      // of the march through the depths, 8..256
    uint bisections; // of where it meets a surface, 0..8
    uint divisor;    // rays are traced at this fraction of the picture's resolution: 1 or 2
    float thickness; // of what the picture shows, as a share of its distance to the eye
};
FN ReflectionParameters defaultReflectionParameters()
{
    ReflectionParameters p;
    p.steps = 64u;
    p.bisections = 4u;
    p.divisor = 2u;
    p.thickness = 0.01f;
    return p;
}

struct ReflectionFrame {
    mat4 worldToClip;
    mat4 clipToWorld;
    vec4 eye; // w = 1: position; 0: the direction towards an orthographic eye
    ivec2 size;
    uint steps;
    uint bisections;
    uint divisor;
    float thicknessShare;
    float thicknessDepths;
    float pixelsPerMetre; // at clip w = 1
};

const int kReflectionDepthLevels = 7; // px squares of 1 to 64
const int kReflectionBlurLevels = 6;  // of what the rays met

// Specialization constants.
const uint kReflectionCubemaps = 0u;  // lighting mirrored the probes, by the split sum
const uint kReflectionFirst = 1u;     // the first level of the pyramid of depths
const uint kReflectionLayer = 2u;     // what is mirrored goes to a second attachment, too
const uint kReflectionRays = 3u;      // each pixel's own ray went through the level
const uint kReflectionFacets = 4u;    // some metal is rough
const uint kReflectionSkyImage = 11u; // beside those of engine/effects/shading.h

const float kLeastNearness = 1e-5f; // 1/m: the sky, as good as infinitely far

// The share that the screen may have of a surface of that roughness, as the G-buffer keeps it: in 255 steps, so that the limit may read one
// lower.
FN float reflectionShare(float roughness)
{
    const float kFadesFrom = 0.75f; // of the limit
    const float kLimit = kScreenRoughness - 1.0f / 255.0f;
    return 1.0f - smoothstep(kFadesFrom * kLimit, kLimit, roughness);
}

// What is met near the border of the picture fades, for beyond it nothing is known.
FN float borderShare(vec2 uv)
{
    const float kFade = 0.06f; // of the picture
    vec2 inside = clamp(min(uv, vec2(1.0f) - uv) * (1.0f / kFade), 0.0f, 1.0f);
    return inside.x * inside.y;
}

// What is met behind a surface may be hidden by it; half of its thickness is trusted.
FN float hiddenShare(float behind) { return clamp(2.0f - 2.0f * behind, 0.0f, 1.0f); }

// A surface met from behind shows the eye another side; `cosine` is that of its front to where the ray comes from.
FN float facingShare(float cosine)
{
    const float kWhole = 0.1f;
    return clamp(cosine * (1.0f / kWhole), 0.0f, 1.0f);
}

// A GGX lobe: half of its facets slope by less than alpha, and a mirrored ray turns by twice the facet's angle.
FN float lobeTangent(float alpha) { return 2.0f * alpha; }

// Slopes, in alpha, of four facets along one line, each standing for a quarter of them: the marginal of GGX's slopes has the distribution
// function (1 + x / sqrt(1 + x^2)) / 2, whose quantiles at 1/8, 3/8, 5/8, 7/8 are s / sqrt(1 - s^2), s = -3/4 .. 3/4.
FN float lobeSlope(int k)
{
    float s = 0.5f * float(k) - 0.75f;
    return s / sqrt(1.0f - s * s);
}
// Of the facets of such a slope x, those across the line have slopes sqrt(1 + x^2) times as wide as in the middle, for GGX's slopes have the
// density 1 / (1 + x^2 + y^2)^2: by how many levels of a pyramid, log2 of that.
FN float lobeWidening(int k)
{
    float x = lobeSlope(k);
    return 0.5f * log2(1.0f + x * x);
}
const float kTapWidth = 0.8f;  // px of a tap's square, in px of the lobe's half width across
const float kNarrowest = 0.6f; // a lobe seen at a grazing angle is narrow across: taps no narrower than the gaps between them

SHARED_END
#endif
