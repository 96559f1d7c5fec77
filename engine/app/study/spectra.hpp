// What three channels lose of a spectrum: a chart of sunlight that was reflected again and again by what has a colour.
#pragma once
#include "engine/core/image.hpp"

namespace afterglow
{
struct Studio;

// Light of a black body of 5778 K off what reflects 2 % and, about 450, 550 and 620 nm (from left to right), 92 %: each third from a band
// of 10 nm to one of 160 nm (of standard deviation), down the chart after 1 to 8 bounces. As bright as the level's picture wherever that
// is, for eyes adapt. By so many wavelengths, evenly spaced; kThreeChannels: by products of red, green and blue.
Image reflectedLight(const Studio& studio, double wavelengths);
constexpr double kThreeChannels = 0.0;
constexpr double kEveryWavelength = 940.0; // by 0.5 nm

// The rows of the chart after so many bounces alone; those off bands of one width.
Image reflectedBy(const Studio& studio, double wavelengths, int bounces);
Image reflectedOff(const Studio& studio, double wavelengths, double nanometres);
}
