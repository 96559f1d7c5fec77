// The filter of what few rays leave, by itself: planes, edges, noise.
#include "engine/effects/local_fit.h"
#include "shaders/random.h"
#include <cmath>
#include <gtest/gtest.h>

namespace afterglow
{
using namespace shared;

namespace
{
// What a function of the place says of 5 x 5 pixels, against what it says of the middle one.
template <typename Value>
LocalFit fitOf(Value value)
{
    LocalFit fit = emptyFit();
    for (int y = -kFitReach; y <= kFitReach; ++y)
        for (int x = -kFitReach; x <= kFitReach; ++x) addTo(fit, fitWeight(x, y), vec2(x, y), vec4(value(x, y) - value(0, 0)));
    return fit;
}
}

// Whatever the noise is said to be.
TEST(LocalFit, KeepsPlanes)
{
    for (const float noise : {0.0f, 0.01f, 1.0f}) {
        EXPECT_EQ(fitted(fitOf([](int, int) { return 0.3f; }), vec4(noise), 1.0f), vec4(0.0f)) << noise;
        const vec4 tilted = fitted(fitOf([](int x, int y) { return 0.5f + 0.07f * float(x) - 0.04f * float(y); }), vec4(noise), 1.0f);
        EXPECT_NEAR(tilted.x, 0.0f, 1e-6f) << noise;
    }
}

TEST(LocalFit, LeavesEverythingWhereThereIsNoNoise)
{
    const auto lot = [](int x, int y) { return hashFloat(uint(31 * x + 7 * y + 400)); };
    EXPECT_EQ(fitted(fitOf(lot), vec4(0.0f), 1.0f), vec4(0.0f));
    const vec4 one = fitted(fitOf(lot), vec4(0.0f, 0.05f, 0.0f, 0.0f), 1.0f); // each value by its own noise
    EXPECT_EQ(one.x, 0.0f);
    EXPECT_NE(one.y, 0.0f);
}

// An edge of height 1 is no noise of a variance v: no more than v / (variance left by the edge) of what the plane says is believed. Beside
// the edge the columns weigh 1/2 1 | 1 1 1/2: the plane leaves at least 0.03 of the variance, and misses by no more than 1.
TEST(LocalFit, KeepsAnEdgeThatTheNoiseDoesNotExplain)
{
    for (const float noise : {1e-6f, 1e-4f, 1e-3f}) {
        const vec4 change = fitted(fitOf([](int x, int) { return x < 0 ? 0.0f : 1.0f; }), vec4(noise), 1.0f);
        EXPECT_LE(std::abs(change.x), noise / 0.03f) << noise;
    }
}

// One surface that shows a pixel, a row or a column alone; nothing at all.
TEST(LocalFit, IsFiniteWhateverTheNeighboursAre)
{
    EXPECT_EQ(fitted(emptyFit(), vec4(0.1f), 1.0f), vec4(0.0f));
    LocalFit alone = emptyFit(), row = emptyFit();
    addTo(alone, 1.0f, vec2(0.0f), vec4(0.0f));
    EXPECT_EQ(fitted(alone, vec4(0.1f), 1.0f), vec4(0.0f));
    for (int x = -2; x <= 2; ++x) addTo(row, 1.0f, vec2(x, 0), vec4(0.1f * float(x)));
    EXPECT_NEAR(fitted(row, vec4(0.1f), 1.0f).x, 0.0f, 1e-6f);
}

// On independent noise around a slope: the mean stays, and the deviation falls to 0.22 of itself at best, the root of the sum of the
// squared weights, 3.5 / 16 along each axis; 0.4 is asked, for what is left by lot is kept.
TEST(LocalFit, TakesNoiseAway)
{
    constexpr uint kTimes = 4000;
    constexpr float kHalf = 0.2f; // evenly within +-0.2: a variance of 0.2^2 / 3
    double sum = 0, square = 0;
    for (uint k = 0; k < kTimes; ++k) {
        const auto value = [k](int x, int y) {
            return 0.05f * float(x) + kHalf * (2.0f * hashFloat(hash3(k, uint(x + 9), uint(y + 9))) - 1.0f);
        };
        const double left = double(value(0, 0) + fitted(fitOf(value), vec4(kHalf * kHalf / 3.0f), 1.0f).x);
        sum += left, square += left * left;
    }
    const double deviation = std::sqrt(square / kTimes);
    EXPECT_LE(deviation, 0.4 * double(kHalf) / std::sqrt(3.0));
    EXPECT_NEAR(sum / kTimes, 0.0, 4.0 * deviation / std::sqrt(double(kTimes)));
}

// The more pictures are averaged, the less is left to the filter.
TEST(LocalFit, FadesAsFramesAreGathered)
{
    const LocalFit fit = fitOf([](int x, int y) { return hashFloat(uint(31 * x + 7 * y + 400)); });
    float last = kFloatMax;
    for (const float frames : {1.0f, 4.0f, 16.0f, 1e6f}) {
        const float change = std::abs(fitted(fit, vec4(0.02f), frames).x);
        EXPECT_LT(change, last);
        last = change;
    }
    EXPECT_LT(last, 1e-5f);
}
}
