// A polynomial through a texel's neighbourhood: the smoothest that its surface and its island allow.
// This work is based on: Cleveland 1979 (local regression), Moon et al. 2014 (of rendered pictures).
#pragma once
#include "baker/islands.hpp"
#include <array>

namespace afterglow
{
// What is smoothed of a texel: light of either half of its paths, and where the light of both comes from, times its luminance. Twelve, three
// of which are 0, for the processor adds them by fours.
using TexelFields = std::array<float, 12>;

struct FitSpan {
    float radius; // texels: the Gaussian's deviation
    int stride;   // every so manieth texel is looked at, to 2.5 deviations
    int order;    // of the polynomial: 1 a plane, 2 a paraboloid
};

// A texel that a fit looks at.
struct FitTap {
    ivec2 step;     // texels
    float terms[8]; // of the polynomial there: 1, x, y, xx, xy, yy, in radii; 0, 0
    float weight;   // of a place like the fit's own
};
std::vector<FitTap> fitTaps(const FitSpan& span);

// The page as a fit sees it.
struct FitPage {
    ivec2 size;
    const Islands& islands;
    const TexelGuides& guides;
    std::vector<float> extent; // m: a texel's edge; 0 of one that has no neighbour
};
FitPage fitPage(const Lightmap& lightmap, const TexelGuides& guides, const Islands& islands);

// The value at a baked texel of the polynomial of that order which fits the fields of its island best, neighbours weighed by their distance on the page, by
// how they face and by how far they lie off the surface. Light may come out below 0.
TexelFields localFit(const FitPage& page, int order, const std::vector<FitTap>& taps, const std::vector<TexelFields>& fields, ivec2 at);
}
