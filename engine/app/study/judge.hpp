// How far a picture is from the truth, when the truth itself is noisy; and how both look.
#pragma once
#include "engine/core/flip.hpp"
#include "engine/frame/settings.hpp"

namespace afterglow
{
// Two independent estimates of one truth; a truth without noise is twice the same. What the two agree on is the truth: the mean of
// (x - a) (x - b) is the mean of (x - truth)^2 without the noise of either, so an error can be told below it.
struct Truth {
    Image a, b;
    Image mean;   // of both
    Image bright; // the same squared, mean over the 7x7 pixels about each: what is bright there, whatever a pixel's own noise is
};
Truth truthOf(Image a, Image b);

enum class Measure {
    radiance, // relative to what the picture shows at the pixel and the truth about it, and to a tenth of the truth's mean: 0 .. 10
    samples,  // the same relative to the truth alone: of pictures that scatter themselves, whose mean must keep its weight
    values    // as it is: visibility, displayed values
};

// Root mean square; 0 where noise is all there is. With two pictures that differ by their own noise alone: of what they agree on, which is
// their bias.
double errorOf(const Image& picture, const Image& again, const Truth& truth, Measure measure);

// The least error that can be told from none: twice the standard error of what errorOf() is the root of, by the noise that the two pictures
// and the two estimates show. 0 where there is none.
double floorOf(const Image& picture, const Image& again, const Truth& truth, Measure measure);

// The standard error of the truth itself, from what its two estimates differ by, in the same unit.
double noiseOf(const Truth& truth);

// Linear 0..1, for FLIP and for a page: radiance exposed for `reference` (or as the level says) and toned; values as grey.
struct Exhibit {
    float exposure = 1.0f;
    uint curve = 0;
    bool values = false; // already 0..1
};
Exhibit exhibitFor(const Image& reference, const DisplayParameters& display);
Image shown(const Image& picture, const Exhibit& exhibit);
}
