// Light in steps. How squarely a surface faces a light is its response, the cosine, 0..1; a ramp answers it with one of a few tones. Where
// shadows leave less than half of the light the response is 0, as where the surface is turned away: the same tone.
// This work is based on: Lake, Marshall, Harris, Blackstein 2000, "Stylized rendering techniques for scalable real-time 3D animation".
#ifndef AFTERGLOW_TONES_H
#define AFTERGLOW_TONES_H
#include "shaders/constants.h"
SHARED_BEGIN

struct ToonStep {
    vec3 tone;  // times the light that a white surface facing it sends back; may exceed 1
    float edge; // the response from which it holds, the edge included; the first holds for everything below, NaN too
};

// `width`: how far the response changes across the pixel. The mean of a step over the pixel, so that an edge is smooth; where the response
// does not change a pixel lies on one side, and where it jumps (a silhouette, the neighbour's surface) the change means nothing.
const float kToonFlat = 1e-5f;
const float kToonJump = 0.25f;
FN float toonShare(float response, float edge, float width)
{
    if (width > kToonFlat && width < kToonJump) return clamp((response - edge) / width + 0.5f, 0.0f, 1.0f);
    return response >= edge ? 1.0f : 0.0f; // false for NaN
}

// How much of a pixel is lit where shadows leave that share of a light: half is the border. It is the middle of a filter or a penumbra, and
// what a map's texels take of surfaces at a slant, or beside their own creases, stays on the lit side. `width` as above; nothing and all of
// the light are what they are, however far the next pixel lies.
FN float toonLit(float share, float width)
{
    if (!(width > kToonFlat)) return share >= 0.5f ? 1.0f : 0.0f;
    return clamp((share - 0.5f) / min(width, 1.0f) + 0.5f, 0.0f, 1.0f);
}

// Equal steps from black to the whole light; one step is the whole light everywhere. `step_`: 0 .. steps - 1.
FN ToonStep evenToonStep(uint step_, uint steps)
{
    ToonStep s;
    s.tone = vec3(steps > 1u ? float(step_) / float(steps - 1u) : 1.0f);
    s.edge = float(step_) / float(steps);
    return s;
}

// What varies without end (a lamp's distance, baked light) falls on a ladder, each rung twice the one below: it needs no level's white, and
// it tells a cellar from a courtyard. `logarithm`: of base 2; `width` as above, of the logarithm.
FN float toonRung(float logarithm, float width)
{
    float edge = floor(logarithm + 0.5f);
    return exp2(edge - 0.5f + toonShare(logarithm, edge, width));
}

// A highlight is the part of the GGX lobe above half its height, as bright as the lobe is there on average: with x = tan^2 / alpha^2 the
// lobe is 1 / (1 + x)^2 of its peak, which is 1/2 at x = sqrt(2) - 1, and its mean over that disc is 1 / sqrt(2).
FN float toonHighlight(float cosHalf, float alpha)
{
    float c2 = cosHalf * cosHalf;
    float x = (1.0f - c2) / max(c2 * alpha * alpha, 1e-12f);
    return 1.0f / ((1.0f + x) * (1.0f + x));
}
const float kToonHighlightEdge = 0.5f;
// Times the interface's reflectance and the light's irradiance: radiance of the disc. A quarter of the peak, 1 / (pi alpha^2), is a
// mirror's of facets that face halfway.
FN float toonHighlightRadiance(float alpha) { return kInvPi * 0.25f * 0.70710678f / max(alpha * alpha, 1e-3f); }

SHARED_END
#endif
