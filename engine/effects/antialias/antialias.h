// Antialias: the frames so far, gathered into one picture. What each pixel of the past is worth, and what it may still be.
#ifndef AFTERGLOW_ANTIALIAS_H
#define AFTERGLOW_ANTIALIAS_H
#include "shaders/color.h"
SHARED_BEGIN

struct AntialiasPush {
    mat4 toLast;         // from clip space, the jitter in it, to the last frame's clip space without jitter
    vec2 jitter;         // px of the drawn picture
    vec2 depthTolerance; // share of the depth, and depth: how far the past's may lie from what it should be
    float most;          // frames that a pixel of the past counts for at most; 0: there is no past
    uint still;          // 1: nothing has moved since the last frame
};

// Specialization constants.
const uint kAntialiasUpscale = 0u; // the drawn picture is smaller than the shown one
const uint kAntialiasMotion = 1u;  // some object moved

// The past counts for as many frames while something moves: more blur what is resampled again and again, fewer let the jitter show.
const float kMovingFrames = 4.0f;
// At rest the mean is exact from the first frame on; beyond so many the last one counts for 1 / kRestingFrames, and nothing stalls.
const float kRestingFrames = 4096.0f;
// What is left of the motion before the rest: it counts as so many frames of the mean.
const float kCarriedFrames = 2.0f;

// A pixel whose own sample fell into another shown pixel (the drawn picture is smaller) is worth this much of a sample.
const float kGuessed = 0.1f;

// Standard deviations around the mean of the neighbours within which the past is believed while something moves (Salvi 2016).
const float kBelieved = 1.25f;

// Luma and two differences: the box of the neighbours' colours is narrow along them.
FN vec3 toLumaChroma(vec3 c) { return vec3(0.25f * (c.x + 2.0f * c.y + c.z), 0.5f * (c.x - c.z), 0.25f * (2.0f * c.y - c.x - c.z)); }
FN vec3 fromLumaChroma(vec3 c) { return vec3(c.x + c.y - c.z, c.x + c.z, c.x - c.y - c.z); }

// `value` pulled toward `mean` until it lies within kBelieved deviations of it on every axis.
FN vec3 believed(vec3 value, vec3 mean, vec3 deviation)
{
    vec3 away = value - mean;
    vec3 most = kBelieved * deviation + vec3(1e-6f);
    float excess = max(max(abs(away.x) / most.x, abs(away.y) / most.y), abs(away.z) / most.z);
    return excess > 1.0f ? mean + away / excess : value;
}

SHARED_END
#endif
