// A ball amid the light of the level's first reflection probe: what look-ups stand for, against what they were made of.
#pragma once
#include "engine/core/image.hpp"

namespace afterglow
{
struct Studio;

// White and matte, lit by spherical harmonics up to that order, 0 to 2; kExact: by every texel around it.
Image matteBall(const Studio& studio, double order);

constexpr double kExact = 64.0; // any order beyond 2

// White and rough, by so many samples of its lobe; kSplitSum: by one look-up of what the bake prefiltered.
Image glossyBall(const Studio& studio, double samples);
constexpr double kSplitSum = 0.0;
}
