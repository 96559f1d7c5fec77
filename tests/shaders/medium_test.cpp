// A medium: what stays, what is added, where it is met, from nothing at all to a wall of fog.
// Closed forms, by their names: medium.transmittance, medium.opacity, medium.height_fog, medium.airlight_directional,
// medium.airlight_point, medium.slab_single.
#include "shaders/medium.h"
#include "shaders/phase.h"
#include "tests/shaders/statistics.hpp"
#include <array>

namespace afterglow::test
{
TEST(Medium, TransmittanceAndOpacity)
{
    expectRelative(transmittance(0.1f, 7.0f), 0.4965853038, 1e-5);
    expectRelative(opacityOf(0.7f), 0.5034146962, 1e-5);
    expectRelative(opacityOf(1e-12f * 10.0f), 1e-11, 1e-5);
    EXPECT_EQ(transmittance(1e6f, 1.0f), 0.0f);
    EXPECT_EQ(opacityOf(1e6f), 1.0f);
    EXPECT_EQ(transmittance(0.0f, 1e30f), 1.0f);
    EXPECT_EQ(transmittance(0.0f, std::numeric_limits<float>::infinity()), 1.0f);
    expectRelative(opacityOf(1e-9f), 9.99999999e-10, 1e-6);
    for (double x = 1e-12; x < 80.0; x *= 1.07) {
        float f = float(x);
        expectRelative(opacityOf(f), -std::expm1(-double(f)), 4e-7);
        expectRelative(meanTransmittance(f), -std::expm1(-double(f)) / double(f), 4e-7);
        expectRelative(meanTransmittance(-f), std::expm1(double(f)) / double(f), 3e-6);
    }
    EXPECT_EQ(meanTransmittance(0.0f), 1.0f);
}

TEST(Medium, IntegratedStepIsExactAtAnyStepCount)
{
    // sigma_s .08, sigma_t .1, D 30, unit source: (sigma_s / sigma_t)(1 - exp(-3))
    for (int steps : {1, 3, 64, 1000}) {
        double radiance = 0.0, through = 1.0;
        float d = 30.0f / float(steps);
        for (int i = 0; i < steps; ++i) {
            radiance += through * double(stepInscatter(0.08f, 0.1f, d));
            through *= double(transmittance(0.1f, d));
        }
        expectRelative(radiance, 0.760170345, 2e-5);
    }
    // A wall of fog: the albedo, at any step count
    for (int steps : {1, 64}) expectRelative(stepInscatter(0.5e6f, 1e6f, 100.0f / float(steps)), 0.5, 1e-5);
    EXPECT_EQ(stepInscatter(0.0f, 0.0f, 1.0f), 0.0f);
    expectRelative(stepInscatter(0.3f, 0.0f, 2.0f), 0.6, 1e-6); // scattering alone, unattenuated
}

TEST(Medium, HeightFog)
{
    struct Row {
        float slope;
        double depth;
    };
    for (const Row& r :
         {Row{0.5f, 1.272094458}, Row{0.0f, 2.456192259}, Row{1e-9f, 2.456192256}, Row{1e-6f, 2.45618857}, Row{-0.3f, 3.983406515}})
        expectRelative(heightFogDepth(0.1f, 10.0f, 2.0f, r.slope, 30.0f), r.depth, 1e-5);
    // From 2000 m down to the ground: 0.1 * 10 m * (1 - exp(-200)), though exp(-200) and exp(200) are not floats
    expectRelative(heightFogDepth(0.1f, 10.0f, 2000.0f, -1.0f, 2000.0f), 1.0, 1e-5);
    EXPECT_EQ(heightFogDepth(0.1f, 10.0f, -5000.0f, -1.0f, 5000.0f), 100.0f);
    EXPECT_EQ(heightFogDepth(0.0f, 10.0f, 0.0f, 0.5f, 1e9f), 0.0f);
}

TEST(Medium, AirlightOfABeam)
{
    double value = double(airlightDirectional(0.08f, 0.1f, phaseHg(0.5f, 0.3f), kPi, 30.0f));
    expectRelative(value, 0.153931247, 1e-5);
}

TEST(Medium, SlabSingleScattering)
{
    struct Row {
        float mu, mu0;
        double r, t;
    };
    for (const Row& c : {Row{0.5f, 0.8f, 0.133092802, 0.09070170817}, Row{0.5f, 0.5f, 0.1104394906, 0.06090087746},
                         Row{0.5f, 0.5000001f, 0.1104395008, 0.06090088964}}) {
        expectRelative(slabReflected(0.9f, kInvFourPi, kPi, 1.0f, c.mu, c.mu0), c.r, 1e-5);
        expectRelative(slabTransmitted(0.9f, kInvFourPi, kPi, 1.0f, c.mu, c.mu0), c.t, 1e-5);
    }
    // Continuous through mu = mu0
    float at = slabTransmitted(1.0f, 1.0f, 1.0f, 1.0f, 0.5f, 0.5f);
    for (float near : {-2e-7f, -1e-4f, 1e-4f}) EXPECT_NEAR(slabTransmitted(1.0f, 1.0f, 1.0f, 1.0f, 0.5f, 0.5f + near), at, 1e-3f);
}

// Single scattering of a point light along a ray, by equiangular sampling of these laws.
TEST(Medium, AirlightOfAPoint)
{
    struct Row {
        double ss, st, s, h, d, g, value;
    };
    for (const Row& r : {Row{0.08, 0.1, 5, 2, 20, 0, 0.003666306671}, Row{0.08, 0.1, 5, 2, 20, 0.7, 0.003444902777},
                         Row{0.01, 0.01, 5, 0.01, 20, 0.9, 1.493196282}, Row{1e-6, 1e-6, 5, 2, 20, 0, 1.045851223e-07}}) {
        const int n = 20000;
        double sum = 0.0;
        for (int i = 0; i < n; ++i) {
            float x = sampleEquiangular(float(r.s), float(r.h), float(r.d), (float(i) + 0.5f) / float(n));
            double along = r.s - double(x), distance = std::hypot(r.h, along);
            double value = r.ss * double(phaseHg(float(r.g), float(along / distance))) / (distance * distance) *
                           double(transmittance(float(r.st), x + float(distance)));
            sum += value / double(equiangularPdf(float(r.s), float(r.h), float(r.d), x)) / n;
        }
        expectRelative(sum, r.value, 1e-4);
    }
    // Through the light itself
    for (float u : {0.0f, 0.5f, 1.0f - 1.0f / 16777216.0f}) {
        float t = sampleEquiangular(5.0f, 0.0f, 20.0f, u);
        EXPECT_TRUE(t >= 0.0f && t <= 20.0f);
        EXPECT_TRUE(std::isfinite(equiangularPdf(5.0f, 0.0f, 20.0f, t)));
    }
}

TEST(Medium, FreeFlightsFollowTheirDensity)
{
    const int bins = 40;
    std::array<std::vector<double>, 2> counts{std::vector<double>(bins, 0.0), std::vector<double>(bins, 0.0)};
    std::vector<double> expected(bins, 100000.0 / bins), equiangular(bins, 0.0);
    Random random;
    for (int i = 0; i < 100000; ++i) {
        float u = random.next(), t = sampleDistance(0.7f, u);
        EXPECT_NEAR(sampleDistanceInverse(0.7f, t), u, 2e-6f);
        counts[0][std::size_t(std::min(int(-std::expm1(-0.7 * double(t)) * bins), bins - 1))] += 1.0;
        counts[1][std::size_t(std::min(int(sampleEquiangular(5.0f, 2.0f, 20.0f, random.next()) / 20.0f * float(bins)), bins - 1))] += 1.0;
    }
    for (int b = 0; b < bins; ++b)
        for (int k = 0; k < 50; ++k)
            equiangular[std::size_t(b)] +=
                double(equiangularPdf(5.0f, 2.0f, 20.0f, 20.0f * (float(b) + (float(k) + 0.5f) / 50.0f) / float(bins))) * 20.0 / bins /
                50.0 * 100000.0;
    EXPECT_LT(chiSquare(counts[0], expected), 4.0);
    EXPECT_LT(chiSquare(counts[1], equiangular), 4.0);
    EXPECT_EQ(sampleDistance(0.0f, 0.5f), kFloatMax);
    EXPECT_EQ(sampleDistance(1.0f, 0.0f), 0.0f);
    EXPECT_TRUE(std::isfinite(sampleDistance(1e-30f, 1.0f - 1.0f / 16777216.0f)));
}

TEST(BoxSpan, HoldsForRaysAlongAndOnTheWalls)
{
    const vec3 lower(-1), upper(1);
    EXPECT_EQ(spanLength(boxSpan(vec3(-2, 0, 0), vec3(1, 0, 0), lower, upper, 99.0f)), 2.0f);
    EXPECT_EQ(spanLength(boxSpan(vec3(-2, 1, 0), vec3(1, 0, 0), lower, upper, 99.0f)), 2.0f) << "on a wall counts as inside";
    EXPECT_EQ(spanLength(boxSpan(vec3(-2, 1.1f, 0), vec3(1, 0, 0), lower, upper, 99.0f)), 0.0f);
    EXPECT_EQ(spanLength(boxSpan(vec3(2, 0, 0), vec3(1, 0, 0), lower, upper, 99.0f)), 0.0f) << "behind";
    EXPECT_EQ(spanLength(boxSpan(vec3(0), vec3(0, 0, -1), lower, upper, 0.5f)), 0.5f) << "cut by the surface";
    const float inf = std::numeric_limits<float>::infinity();
    EXPECT_EQ(spanLength(boxSpan(vec3(0), vec3(0, 0, -1), vec3(-inf), vec3(inf), 7.0f)), 7.0f) << "everywhere";
}
}
