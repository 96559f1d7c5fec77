#include "baker/daylight.hpp"
#include <algorithm>
#include <cmath>

namespace afterglow
{
namespace
{
// The mean of measured daylight and its two main deviations, 360..830 nm by 10 (CIE 15, table T.2; Judd, MacAdam & Wyszecki 1964).
constexpr float kFirst = 360.0f, kStep = 10.0f; // nm
constexpr int kCount = 48;
constexpr float kMean[kCount] = {61.5f,  68.8f,  63.4f,  65.8f,  94.8f,  104.8f, 105.9f, 96.8f,  113.9f, 125.6f, 125.5f, 121.3f,
                                 121.3f, 113.5f, 113.1f, 110.8f, 106.5f, 108.8f, 105.3f, 104.4f, 100.0f, 96.0f,  95.1f,  89.1f,
                                 90.5f,  90.3f,  88.4f,  84.0f,  85.1f,  81.9f,  82.6f,  84.9f,  81.3f,  71.9f,  74.3f,  76.4f,
                                 63.3f,  71.7f,  77.0f,  65.2f,  47.7f,  68.6f,  65.0f,  66.0f,  61.0f,  53.3f,  58.9f,  61.9f};
constexpr float kBlueYellow[kCount] = {38.0f,  42.4f,  38.5f,  35.0f,  43.4f,  46.3f,  43.9f,  37.1f,  36.7f,  35.9f,  32.6f,  27.9f,
                                       24.3f,  20.1f,  16.2f,  13.2f,  8.6f,   6.1f,   4.2f,   1.9f,   0.0f,   -1.6f,  -3.5f,  -3.5f,
                                       -5.8f,  -7.2f,  -8.6f,  -9.5f,  -10.9f, -10.7f, -12.0f, -14.0f, -13.6f, -12.0f, -13.3f, -12.9f,
                                       -10.6f, -11.6f, -12.2f, -10.2f, -7.8f,  -11.2f, -10.4f, -10.6f, -9.7f,  -8.3f,  -9.3f,  -9.8f};
constexpr float kGreenPurple[kCount] = {5.3f,  6.1f,  3.0f,  1.2f,  -1.1f, -0.5f, -0.7f, -1.2f, -2.6f, -2.9f, -2.8f, -2.6f,
                                        -2.6f, -1.8f, -1.5f, -1.3f, -1.2f, -1.0f, -0.5f, -0.3f, 0.0f,  0.2f,  0.5f,  2.1f,
                                        3.2f,  4.1f,  4.7f,  5.1f,  6.7f,  7.3f,  8.6f,  9.8f,  10.2f, 8.3f,  9.6f,  8.5f,
                                        7.0f,  7.6f,  8.0f,  6.7f,  5.2f,  7.4f,  6.8f,  7.0f,  6.4f,  5.5f,  6.1f,  6.5f};
}

float Daylight::at(float wavelength) const
{
    const float place = std::clamp((wavelength - kFirst) / kStep, 0.0f, float(kCount - 1));
    const int below = std::min(int(place), kCount - 2);
    const auto power = [&](int i) { return kMean[i] + shares.x * kBlueYellow[i] + shares.y * kGreenPurple[i]; };
    return std::lerp(power(below), power(below + 1), place - float(below)) * 0.01f;
}
}
