// Errors below the noise of the truth, and errors that stay within bounds.
#include "engine/app/study/judge.hpp"
#include "shaders/random.h"
#include <cmath>
#include <gtest/gtest.h>

namespace afterglow
{
static Image even(float value, int edge = 128)
{
    Image image(edge, edge, 3);
    for (float& pixel : image.pixels) pixel = value;
    return image;
}

// Evenly spread about the value by up to 1 to each side: variance 1/3.
static Image noisy(float value, uint seed)
{
    Image image = even(value);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        shared::Sampler random = makeSampler(seed, uint(i));
        image.pixels[i] += 2.0f * next1(random) - 1.0f;
    }
    return image;
}

// Of n = 49152 values the mean of (x - a)(x - b) is off by sqrt(var^2 + 2 d^2 var) / sqrt(n) = 0.0017 of d^2 = 0.04: four of them are 0.017
// of d.
TEST(StudyJudge, tells_an_error_below_the_noise_of_its_truth)
{
    const Truth truth = truthOf(noisy(2.0f, 1u), noisy(2.0f, 2u));
    const Image picture = even(2.2f);
    EXPECT_NEAR(errorOf(picture, picture, truth, Measure::values), 0.2, 0.017);
    EXPECT_LT(errorOf(even(2.0f), even(2.0f), truth, Measure::values), std::sqrt(4.0 * 0.0017));
}

// Noise of the picture itself counts; of two such pictures, only what they agree on.
TEST(StudyJudge, tells_bias_from_noise)
{
    const Truth truth = truthOf(noisy(2.0f, 1u), noisy(2.0f, 2u));
    const Image x = noisy(2.2f, 3u), y = noisy(2.2f, 4u);
    EXPECT_NEAR(errorOf(x, x, truth, Measure::values), std::sqrt(0.04 + 1.0 / 3.0), 0.01);
    EXPECT_NEAR(errorOf(x, y, truth, Measure::values), 0.2, 0.02);
}

// Of noise of variance s^2 = 1/3 alone the mean of n = 16384 products has the standard error s^2 / sqrt(n); with an error e, that of
// variance s^4 + 2 e^2 s^2; twice as much is told from none.
TEST(StudyJudge, knows_what_it_cannot_tell)
{
    const Truth truth = truthOf(noisy(2.0f, 1u), noisy(2.0f, 2u));
    const double alone = std::sqrt(1.0 / 9.0) / 128.0, off = std::sqrt(1.0 / 9.0 + 2.0 * 0.04 / 3.0) / 128.0;
    EXPECT_NEAR(floorOf(even(2.0f), even(2.0f), truth, Measure::values), std::sqrt(2.0 * alone), 0.003);
    EXPECT_NEAR(floorOf(even(2.2f), even(2.2f), truth, Measure::values), std::sqrt(2.0 * off), 0.003);
    EXPECT_EQ(floorOf(even(2.2f), even(2.2f), truthOf(even(2.0f), even(2.0f)), Measure::values), 0.0);
    // Two pictures with noise of their own: s^2 is twice as much
    EXPECT_NEAR(floorOf(noisy(2.0f, 3u), noisy(2.0f, 4u), truth, Measure::values), std::sqrt(4.0 * alone), 0.004);
}

// What is right is seldom said to be wrong, what is wrong by twice as much as can be told is always seen.
TEST(StudyJudge, tells_right_from_wrong)
{
    int wronged = 0, missed = 0;
    for (uint seed = 0; seed < 100; ++seed) {
        const auto scattered = [&](float value, uint which) {
            Image image = even(value, 64);
            for (std::size_t i = 0; i < image.pixels.size(); ++i) {
                shared::Sampler random = makeSampler(hash2(seed, which), uint(i / 3)); // channels share their paths
                image.pixels[i] = next1(random) < 0.25f ? 4.0f * value : 0.0f;
            }
            return image;
        };
        const Truth truth = truthOf(scattered(1.0f, 1), scattered(1.0f, 2));
        const auto told = [&](float value) {
            const Image x = scattered(value, 3), y = scattered(value, 4);
            return errorOf(x, y, truth, Measure::values) > floorOf(x, y, truth, Measure::values);
        };
        wronged += told(1.0f), missed += !told(2.5f);
    }
    EXPECT_LE(wronged, 8); // of 100; of the normal distribution 2.3, and these have longer tails
    EXPECT_EQ(missed, 0);
}

TEST(StudyJudge, knows_the_noise_of_a_truth)
{
    // Standard error of the mean of two values of variance 1/3, over sqrt(0.5 (20^2 + 20^2) + 2^2), the noise being small beside 20
    EXPECT_NEAR(noiseOf(truthOf(noisy(20.0f, 1u), noisy(20.0f, 2u))), std::sqrt(1.0 / 6.0) / std::sqrt(404.0), 2e-4);
}

// One pixel as bright as you like is one pixel: error^2 <= (x - t)^2 / (x^2 / 2) < 2.
TEST(StudyJudge, a_lamp_is_no_boundless_error)
{
    const Truth truth = truthOf(even(1.0f), even(1.0f));
    Image picture = even(1.0f);
    for (int c = 0; c < 3; ++c) picture.at(5, 5)[c] = 1e6f;
    EXPECT_NEAR(errorOf(picture, picture, truth, Measure::radiance), std::sqrt(2.0) / 128.0, 1e-4);
    EXPECT_NEAR(errorOf(even(1.01f), even(1.01f), truth, Measure::radiance), 0.01 / std::sqrt(0.5 * (1.0 + 1.01 * 1.01) + 0.01), 1e-5);
}

// As path tracers scatter: mostly dark, now and then four times the mean. The picture that is right must beat one that is too dark.
TEST(StudyJudge, is_not_drawn_to_the_dark_by_rare_bright_samples)
{
    const auto rare = [](uint seed) {
        Image image = even(0.0f);
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            shared::Sampler random = makeSampler(seed, uint(i));
            image.pixels[i] = next1(random) < 0.25f ? 4.0f : 0.0f;
        }
        return image;
    };
    const Truth truth = truthOf(rare(1u), rare(2u));
    const double right = errorOf(even(1.0f), even(1.0f), truth, Measure::radiance);
    EXPECT_LT(right, 0.3); // its own noise alone
    EXPECT_GT(errorOf(even(0.6f), even(0.6f), truth, Measure::radiance), right);
    EXPECT_GT(errorOf(even(1.6f), even(1.6f), truth, Measure::radiance), right);
}

TEST(StudyJudge, two_black_pictures_agree)
{
    const Truth truth = truthOf(even(0.0f), even(0.0f));
    EXPECT_EQ(errorOf(even(0.0f), even(0.0f), truth, Measure::radiance), 0.0);
}

TEST(StudyJudge, shows_radiance_exposed_and_values_as_they_are)
{
    const Exhibit plain = exhibitFor(even(5.0f), DisplayParameters{.exposureEv = {}, .curve = ToneCurve::none});
    EXPECT_NEAR(shown(even(5.0f), plain).at(0, 0)[0], 0.18f, 1e-4f); // middle grey
    EXPECT_EQ(shown(even(-1.0f), Exhibit{.values = true}).at(0, 0)[1], 0.0f);
    EXPECT_EQ(shown(even(0.25f), Exhibit{.values = true}).at(0, 0)[1], 0.25f);
}
}
