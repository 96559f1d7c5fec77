// How far two pictures are apart, in numbers. FLIP, which asks how far they look apart, is in flip.hpp.
#pragma once
#include "engine/core/image.hpp"
#include <optional>

namespace afterglow
{
// All over every pixel and colour channel (alpha left out) that is finite in both; `b` is the reference.
struct Difference {
    double rmse = 0;         // sqrt(mean (a - b)^2), in the pictures' own unit
    double relativeRmse = 0; // rmse / mean(b): 1 % reads as 0.01; 0 where the mean is 0 and the pictures agree
    double relMse = 0;       // mean of (a - b)^2 / (b^2 + 0.01), after Rousselle et al. 2011
    double meanA = 0, meanB = 0;
    std::optional<double> psnr;    // dB, absent when the pictures agree exactly
    double largest = 0;            // largest |a - b| of one channel
    int x = 0, y = 0, channel = 0; // ... and where
    std::uint64_t nonFinite = 0;   // values left out because one of the two is NaN or Inf
};

// `peak` is what PSNR measures against: 1 for displayed values; 0 asks for the largest value of `b`. Throws Error when sizes differ, or no
// value is finite in both.
Difference difference(const Image& a, const Image& b, double peak);
}
