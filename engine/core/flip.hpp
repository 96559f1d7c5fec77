// FLIP: the difference that a person sees when flipping between two pictures, 0 (none) to 1 per pixel.
// This work is based on: Andersson et al. 2020, "FLIP: A Difference Evaluator for Alternating Images"; Andersson et al. 2021, "Visualizing
// Errors in Rendered High Dynamic Range Images" (HDR-FLIP).
#pragma once
#include "engine/core/image.hpp"

namespace afterglow
{
// 0.7 m before a monitor 0.7 m wide of 3840 pixels: the setting of the papers, so that numbers compare.
constexpr float kPixelsPerDegree = 67.0206f;

struct Flip {
    Image map; // one channel, 0..1
    double mean = 0;
};

// Linear Rec.709 of displayed pictures, 0..1 (clamped).
Flip flipDisplayed(const Image& test, const Image& reference, float pixelsPerDegree = kPixelsPerDegree);

// Scene-linear Rec.709 radiance: the largest LDR-FLIP over the exposures that the reference calls for, ACES tone curve.
Flip flipRadiance(const Image& test, const Image& reference, float pixelsPerDegree = kPixelsPerDegree);
}
