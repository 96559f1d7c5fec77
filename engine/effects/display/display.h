// Display: from scene radiance to what a screen shows.
#ifndef AFTERGLOW_DISPLAY_H
#define AFTERGLOW_DISPLAY_H
#include "shaders/exposure.h"
SHARED_BEGIN

struct DisplayPush {
    float exposure; // factor on radiance; 0: from the picture's own brightness
    uint curve;     // kTone...
};

struct ExposurePush {
    float adapt; // share of the way, in EV, from the last frame's exposure to this picture's: 1 is there at once
};

const uint kExposureAdapts = 0u; // specialization constant of exposure.comp: the last frame's exposure is bound

// A picture's brightness: the log luminance of a grid of points, counted in bins, and averaged without the darkest and the brightest.
const uint kExposureThreads = 128u; // what every device has in a group
const uint kExposureBins = 256u;
const uint kExposureColumns = 256u; // of the grid
const uint kExposureRows = 144u;
const float kExposureLowest = -17.0f;  // EV of the first bin: below the darkest that is counted
const float kExposureBinsAnEv = 7.75f; // 256 bins reach to 2^16, the largest half
const float kExposureFine = 4096.0f;   // steps within a bin: a picture of one radiance is measured to 1e-4, and no sum overflows
const float kExposureTrimmed = 0.1f;   // share of the points that is left out at either end

const float kLargestExposure = 1e5f; // a black picture stays black and finite

// Where a radiance is counted, in bins, 0 .. kExposureBins; negative: nowhere.
FN float exposurePlace(vec3 radiance)
{
    float l = luminance(radiance);
    if (!(l > kDarkestCounted)) return -1.0f;
    return min((log2(min(l, kHalfMax)) - kExposureLowest) * kExposureBinsAnEv, float(kExposureBins) - 0.001f);
}

// How many of the `count` points in the bin have a rank from `low` to `high`, when `before` lie below the bin.
FN float exposureTaken(float before, float count, float low, float high) { return max(0.0f, min(before + count, high) - max(before, low)); }

// `mean`: in bins, of the `counted` points that take part.
FN float exposureFromMean(float mean, float counted)
{
    if (!(counted > 0.0f)) return 1.0f;
    return min(kMiddleGrey / exp2(mean / kExposureBinsAnEv + kExposureLowest), kLargestExposure);
}

// A share of the way from one exposure to another, even in EV; from nothing (0) at once.
FN float adaptedExposure(float last, float now, float share) { return last > 0.0f ? last * pow(now / last, share) : now; }

SHARED_END
#endif
