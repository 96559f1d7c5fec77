// What a bake of a level is off by, from four short trials: no truth is asked. Two of other numbers of paths tell the noise, those of a
// half and a quarter of the texels what texels leave out, and how that goes with their density.
#pragma once
#include "baker/baker.hpp"

namespace afterglow
{
// Root mean square over the lightmapped surfaces' area, relative to the mean irradiance; after the filter.
struct PaceError {
    double noise = 0.0;  // of one path a texel; it goes as the root of their number
    double texels = 0.0; // at 1 texel a metre; it goes as density^-slope
    double slope = 1.0;
};
double errorOf(const PaceError& error, const BakeOptions& options); // `options`: resolved; both are independent

// A trial bake, and how it was made.
struct TrialBake {
    Baked baked;
    int samples = 0; // of a texel
    float texelsPerMetre = 0.0f;
};

// How far two bakes of a level lie apart, relative to the second, at points of its lightmapped surfaces; 0 in a level without light.
double paceDifference(const Baked& a, const Baked& b);

// `fewer` and `fine` have other seeds and numbers of paths, `half` and `quarter` that share of the density of `fine`. Richardson's
// extrapolation: with each halving the error grows by 2^slope, and so do its changes, of which two are seen. A level without light: no
// error.
PaceError paceError(const TrialBake& fewer, const TrialBake& fine, const TrialBake& half, const TrialBake& quarter);
}
