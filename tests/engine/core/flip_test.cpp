// FLIP against numbers of the papers' own implementation (flip-evaluator 1.x), on pictures that a formula draws on both sides.
#include "engine/core/flip.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace afterglow
{
constexpr int kWidth = 64, kHeight = 48;

template <class Color>
static Image drawn(Color color, int width = kWidth, int height = kHeight)
{
    Image image(width, height, 3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c) image.at(x, y)[c] = color(x, y, c);
    return image;
}

// Red grows to the right, green downwards; a yellow square of 16 pixels stands at x = 20 + moved.
static float square(int x, int y, int c, int moved)
{
    if (y >= 12 && y < 28 && x >= 20 + moved && x < 36 + moved) return c == 0 ? 0.9f : c == 1 ? 0.8f : 0.1f;
    return c == 0 ? (float(x) + 0.5f) / float(kWidth) : c == 1 ? (float(y) + 0.5f) / float(kHeight) : 0.25f;
}

static float noise(int x, int y, int c, unsigned seed)
{
    unsigned v = unsigned(x) * 1103515245u + unsigned(y) * 12345u + unsigned(c) * 2654435761u + seed * 40503u;
    v = (v ^ (v >> 15)) * 2246822519u;
    v ^= v >> 13;
    return float(v >> 16) / 65535.0f;
}

struct Pair {
    Image reference, test;
};
static Pair squareMoved()
{
    return {drawn([](int x, int y, int c) { return square(x, y, c, 0); }), drawn([](int x, int y, int c) { return square(x, y, c, 3); })};
}
static Pair twoNoises()
{
    return {drawn([](int x, int y, int c) { return noise(x, y, c, 1); }), drawn([](int x, int y, int c) { return noise(x, y, c, 2); })};
}
static Pair redAndHalfRed()
{
    return {drawn([](int, int, int c) { return c == 0 ? 0.8f : 0.1f; }), drawn([](int, int, int c) { return c == 0 ? 0.4f : 0.05f; })};
}
static Pair noisySquare()
{
    const auto noisy = [](int x, int y, int c) {
        return std::fmin(std::fmax(square(x, y, c, 0) + 0.1f * (noise(x, y, c, 3) - 0.5f), 0.0f), 1.0f);
    };
    return {squareMoved().reference, drawn(noisy)};
}

// From dark to bright along the diagonal, sixteen stops.
static Pair brighter(Pair pair)
{
    for (Image* image : {&pair.reference, &pair.test})
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x)
                for (int c = 0; c < 3; ++c) image->at(x, y)[c] *= std::exp2(0.15f * float(x + y) - 4.0f);
    return pair;
}

struct Expected {
    double mean;
    float centre, corner, lastCorner; // at (30, 20), (0, 0), (63, 47)
};
static void expectFlip(const Flip& flip, const Expected& expected)
{
    constexpr double digits = 1e-4; // their filters are summed in another order, and their colour matrices have other last digits
    EXPECT_NEAR(flip.mean, expected.mean, digits);
    EXPECT_NEAR(*flip.map.at(30, 20), expected.centre, digits);
    EXPECT_NEAR(*flip.map.at(0, 0), expected.corner, digits);
    EXPECT_NEAR(*flip.map.at(63, 47), expected.lastCorner, digits);
}
static Flip displayed(const Pair& pair) { return flipDisplayed(pair.test, pair.reference); }
static Flip radiance(const Pair& pair) { return flipRadiance(pair.test, pair.reference); }

TEST(Flip, of_displayed_pictures_is_the_paper_s)
{
    expectFlip(displayed(squareMoved()), {0.078703, 0.119948f, 0.0f, 0.0f});
    expectFlip(displayed(twoNoises()), {0.403895, 0.451742f, 0.435018f, 0.859056f});
    expectFlip(displayed(redAndHalfRed()), {0.619736, 0.619736f, 0.619736f, 0.619736f});
    expectFlip(displayed(noisySquare()), {0.066507, 0.069589f, 0.069149f, 0.109037f});
}

TEST(Flip, from_further_away_sees_less)
{
    const Pair pair = squareMoved();
    EXPECT_NEAR(flipDisplayed(pair.test, pair.reference, 30.0f).mean, 0.057575, 1e-4);
}

TEST(Flip, of_radiance_is_the_paper_s)
{
    expectFlip(radiance(brighter(squareMoved())), {0.062419, 0.120247f, 0.0f, 0.0f});
    expectFlip(radiance(brighter(twoNoises())), {0.338488, 0.359645f, 0.042581f, 0.733922f});
    expectFlip(radiance(brighter(redAndHalfRed())), {0.547046, 0.574281f, 0.064482f, 0.513534f});
    expectFlip(radiance(brighter(noisySquare())), {0.054247, 0.065909f, 0.000327f, 0.114788f});
}

TEST(Flip, takes_the_median_of_an_odd_count)
{
    const Image reference = drawn([](int x, int y, int c) { return 4.0f * noise(x, y, c, 1); }, 63, 47);
    const Image test = drawn([](int x, int y, int c) { return 4.0f * noise(x, y, c, 2); }, 63, 47);
    EXPECT_NEAR(flipRadiance(test, reference).mean, 0.349496, 1e-4);
}

TEST(Flip, of_a_picture_with_itself_is_zero_and_never_leaves_0_to_1)
{
    const Pair pair = twoNoises();
    EXPECT_EQ(flipDisplayed(pair.test, pair.test).mean, 0.0);
    EXPECT_EQ(flipRadiance(pair.test, pair.test).mean, 0.0);
    const Image black = drawn([](int, int, int) { return 0.0f; });
    const Image wild = drawn([](int x, int, int) { return x % 3 == 0 ? NAN : x % 3 == 1 ? INFINITY : -1.0f; });
    for (const Flip& flip : {flipDisplayed(wild, black), flipRadiance(wild, black), flipRadiance(black, wild), flipRadiance(black, black)})
        for (float error : flip.map.pixels) EXPECT_TRUE(error >= 0.0f && error <= 1.0f) << error;
}
}
