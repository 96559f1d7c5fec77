// Shapes: each sampler against its density, its inverse, and the numbers 0 and 1 - 2^-24; and the two heuristics.
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
            vec3 b = sampleTriangle(u);
            EXPECT_GE(std::min(std::min(b.x, b.y), b.z), 0.0f);
            EXPECT_NEAR(b.x + b.y + b.z, 1.0f, 1e-6f);
        }
}

TEST(Sampling, SmallConesKeepTheirDigits)
{
    EXPECT_NEAR(coneSolidAngle(1e-5f), 3.14159265e-10, 1e-5 * 3.14e-10);
    EXPECT_NEAR(coneSolidAngle(std::sin(0.2664531072f * kPi / 180.0f)), 6.794310706e-05, 1e-5 * 6.8e-5);
    EXPECT_NEAR(coneSolidAngle(1.0f), kTwoPi, 1e-6f);
}

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

// int_0^1 x^k dx from one sample each of p = 1 and p = 2x: mean and variance in closed form.
TEST(Heuristics, HaveTheirClosedVariance)
{
    struct Row {
        double k, truth, balance, power;
    };
    for (const Row& r : {Row{2, 1.0 / 3.0, 0.01872105861, 0.01817598678}, Row{1, 0.5, 0.01111098815, 0.01325022005}}) {
        Random random;
        Mean balance, power;
        for (int i = 0; i < 400000; ++i) {
            float a = random.next(), b = std::sqrt(random.next());
            auto estimate = [&](auto heuristic) {
                double first = std::pow(double(a), r.k) * double(heuristic(1.0f, 2.0f * a));
                double second = b > 0.0f ? std::pow(double(b), r.k) / (2.0 * double(b)) * double(heuristic(2.0f * b, 1.0f)) : 0.0;
                return first + second;
            };
            balance.add(estimate(balanceHeuristic));
            power.add(estimate(powerHeuristic));
        }
        EXPECT_NEAR(balance.value(), r.truth, 4.0 * balance.error());
        EXPECT_NEAR(power.value(), r.truth, 4.0 * power.error());
        expectRelative(balance.variance(), r.balance, 0.05);
        expectRelative(power.variance(), r.power, 0.05);
    }
}

// Estimates of E / pi under a unit sky, and of a disc light by its area and by its solid angle.
TEST(Sampling, VariancesOfStrategies)
{
    Random random;
    Mean cosine, hemisphere, sphere;
    for (int i = 0; i < 400000; ++i) {
        vec2 u = random.next2();
        vec3 c = sampleCosineHemisphere(u);
        cosine.add(double(c.z * kInvPi / cosineHemispherePdf(c.z)));
        hemisphere.add(double(sampleUniformHemisphere(u).z * kInvPi / uniformHemispherePdf()));
        sphere.add(double(std::max(sampleUniformSphere(u).z, 0.0f) * kInvPi / uniformSpherePdf()));
    }
    EXPECT_NEAR(cosine.variance(), 0.0, 1e-9);
    EXPECT_NEAR(hemisphere.variance() * 3.0, 1.0, 0.05);
    EXPECT_NEAR(sphere.variance() / (5.0 / 3.0), 1.0, 0.05);

    struct Row {
        double radius, height, area, solid;
    };
    for (const Row& r : {Row{1, 1, 0.4112335167, 0.02421116893}, Row{2, 0.5, 43.88455079, 1.082997211}}) {
        Mean byArea, bySolidAngle;
        float h = float(r.height), sine = float(r.radius / std::hypot(r.radius, r.height));
        for (int i = 0; i < 400000; ++i) {
            vec2 p = sampleDisc(random.next2()) * float(r.radius);
            float d2 = dot(p, p) + h * h, c = h / std::sqrt(d2);
            byArea.add(double(c / areaPdfToSolidAngle(float(1.0 / (M_PI * r.radius * r.radius)), d2, c)));
            bySolidAngle.add(double(sampleUniformCone(sine, random.next2()).z / uniformConePdf(sine)));
        }
        double truth = M_PI * r.radius * r.radius / (r.radius * r.radius + r.height * r.height);
        EXPECT_NEAR(byArea.value(), truth, 4.0 * byArea.error());
        EXPECT_NEAR(bySolidAngle.value(), truth, 4.0 * bySolidAngle.error());
        expectRelative(byArea.variance(), r.area, 0.05);
        expectRelative(bySolidAngle.variance(), r.solid, 0.05);
    }
}
}
