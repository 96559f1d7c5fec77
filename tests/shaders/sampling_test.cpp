// Shapes: each sampler against its density, its inverse, and the numbers 0 and 1 - 2^-24; and the two heuristics at their ends.
#include "shaders/sampling.h"
#include "tests/shaders/statistics.hpp"
#include <gtest/gtest.h>

namespace afterglow::test
{
namespace
{
const float kLast = 1.0f - 1.0f / 16777216.0f;
}

TEST(Sampling, DirectionsFollowTheirDensities)
{
    auto judge = [](auto sample, auto pdf, double low) {
        return directionChiSquare(
            [&](Random& r, vec3& d) {
                d = sample(r.next2());
                return true;
            },
            pdf, 200000, low);
    };
    EXPECT_LT(judge(
                  sampleCosineHemisphere, [](vec3 d) { return double(cosineHemispherePdf(d.z)); }, 0.0),
              4.0);
    EXPECT_LT(judge(
                  sampleUniformHemisphere, [](vec3) { return double(uniformHemispherePdf()); }, 0.0),
              4.0);
    EXPECT_LT(judge(
                  sampleUniformSphere, [](vec3) { return double(uniformSpherePdf()); }, -1.0),
              4.0);
    float sine = 0.6f; // cos = 0.8
    EXPECT_LT(judge([&](vec2 u) { return sampleUniformCone(sine, u); }, [&](vec3) { return double(uniformConePdf(sine)); }, 0.8 - 1e-7),
              4.0);
}

TEST(Sampling, DiscAndTriangleAreUniform)
{
    Random random;
    const int n = 12;
    std::vector<double> disc(n * n, 0.0), triangle(n * n, 0.0), discExpected(n * n, 100000.0 / (n * n)), triangleExpected = discExpected;
    for (int i = 0; i < 100000; ++i) {
        vec2 p = sampleDisc(random.next2());
        double ring = double(dot(p, p)), turn = std::atan2(double(p.y), double(p.x)) / (2.0 * M_PI) + 0.5;
        disc[std::size_t(std::min(int(ring * n), n - 1) * n + std::min(int(turn * n), n - 1))] += 1.0;
        vec3 b = sampleTriangle(random.next2());
        // Map the uniform triangle to the square: 1 - (1 - b0)^2 and b1 / (1 - b0)
        double x = 1.0 - std::pow(1.0 - double(b.x), 2.0), y = double(b.y) / (1.0 - double(b.x));
        triangle[std::size_t(std::min(int(x * n), n - 1) * n + std::min(int(y * n), n - 1))] += 1.0;
    }
    EXPECT_LT(chiSquare(disc, discExpected), 4.0);
    EXPECT_LT(chiSquare(triangle, triangleExpected), 4.0);
}

TEST(Sampling, InversesComeBack)
{
    Random random;
    for (int i = 0; i < 20000; ++i) {
        vec2 u = random.next2();
        EXPECT_NEAR(length(sampleCosineHemisphereInverse(sampleCosineHemisphere(u)) - u), 0.0f, 2e-4f); // sqrt at the horizon
        EXPECT_NEAR(length(sampleUniformHemisphereInverse(sampleUniformHemisphere(u)) - u), 0.0f, 1e-4f);
        EXPECT_NEAR(length(sampleUniformSphereInverse(sampleUniformSphere(u)) - u), 0.0f, 1e-4f);
        EXPECT_NEAR(length(sampleTriangleInverse(sampleTriangle(u)) - u), 0.0f, 1e-6f);
        vec2 cone = sampleUniformConeInverse(0.004650475f, sampleUniformCone(0.004650475f, u)) - u;
        EXPECT_NEAR(cone.x, 0.0f, 1e-5f);
        EXPECT_NEAR(std::abs(std::remainder(cone.y, 1.0f)), 0.0f, 1e-4f);
    }
}

// H41, of shapes; of surfaces, phase functions and lights beside those.
TEST(Sampling, TheEndsOfTheUnitIntervalAreSafe)
{
    for (float x : {0.0f, 0.5f, kLast})
        for (float y : {0.0f, 0.5f, kLast}) {
            vec2 u(x, y);
            vec3 cosine = sampleCosineHemisphere(u);
            EXPECT_NEAR(length(cosine), 1.0f, 1e-6f);
            EXPECT_GT(cosineHemispherePdf(cosine.z), 0.0f);
            for (vec3 d : {sampleUniformHemisphere(u), sampleUniformSphere(u), sampleUniformCone(1e-6f, u), sampleUniformCone(1.0f, u)})
                EXPECT_NEAR(length(d), 1.0f, 1e-6f);
            for (float sine : {1e-6f, 1.0f}) EXPECT_TRUE(uniformConePdf(sine) > 0.0f && std::isfinite(uniformConePdf(sine)));
            EXPECT_LE(length(sampleDisc(u)), 1.0f + 1e-6f);
            vec3 b = sampleTriangle(u);
            EXPECT_GE(std::min(std::min(b.x, b.y), b.z), 0.0f);
            EXPECT_NEAR(b.x + b.y + b.z, 1.0f, 1e-6f);
        }
}

// H32: the sun's disc, whose 1 - cos is 1e-5.
TEST(Sampling, SmallConesKeepTheirDigits)
{
    EXPECT_NEAR(coneSolidAngle(1e-5f), 3.14159265e-10, 1e-5 * 3.14e-10);
    EXPECT_NEAR(coneSolidAngle(std::sin(0.2664531072f * kPi / 180.0f)), 6.794310706e-05, 1e-5 * 6.8e-5);
    EXPECT_NEAR(coneSolidAngle(1.0f), kTwoPi, 1e-6f);
}

// H40: densities at the ends of what a float holds, denormals among them.
TEST(Heuristics, NeverOverflowAndSumToOne)
{
    EXPECT_EQ(powerHeuristic(1e20f, 1.0f), 1.0f);
    EXPECT_NEAR(powerHeuristic(1.0f, 1e20f), 0.0f, 1e-30f);
    EXPECT_EQ(powerHeuristic(0.0f, 1.0f), 0.0f);
    EXPECT_EQ(balanceHeuristic(0.0f, 0.0f), 0.0f);
    for (float a : {1e-40f, 1e-20f, 1e-3f, 1.0f, 7.0f, 1e20f, 3e38f})
        for (float b : {1e-40f, 1e-20f, 1e-3f, 1.0f, 7.0f, 1e20f, 3e38f}) {
            EXPECT_NEAR(powerHeuristic(a, b) + powerHeuristic(b, a), 1.0f, 1e-6f);
            EXPECT_NEAR(balanceHeuristic(a, b) + balanceHeuristic(b, a), 1.0f, 1e-6f);
        }
}
}
