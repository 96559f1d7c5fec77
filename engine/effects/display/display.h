// Display: from scene radiance to what a screen shows.
#ifndef AFTERGLOW_DISPLAY_H
#define AFTERGLOW_DISPLAY_H
#include "shaders/color.h"
SHARED_BEGIN

struct DisplayPush {
    float exposure; // factor on radiance; 0: from the picture's own brightness
    uint curve;     // kTone...
};

// The picture is judged by a grid of samples, each the sum over a block of 4 x 4 points.
const uint kExposureWidth = 64u;
const uint kExposureHeight = 36u;

const float kMiddleGrey = 0.18f;     // what the picture's mean luminance is shown as
const float kDarkestCounted = 1e-5f; // luminance below it is no part of the mean: the void around a level does not brighten it
const float kLargestExposure = 1e5f; // a black picture stays black and finite

// x: sum of log2 luminance, y: how many were counted.
FN vec2 exposureSample(vec3 radiance)
{
    float l = luminance(radiance);
    return l > kDarkestCounted ? vec2(log2(min(l, kHalfMax)), 1.0f) : vec2(0.0f, 0.0f);
}
FN float exposureFromMean(vec2 sum)
{
    if (!(sum.y > 0.0f)) return 1.0f;
    return min(kMiddleGrey / exp2(sum.x / sum.y), kLargestExposure);
}

SHARED_END
#endif
