// Irradiance probes: where they stand, who weighs what, and visibility by moments.
#include "shaders/probe.h"
#include "tests/shaders/statistics.hpp"

namespace afterglow::test
{
namespace
{
float sumOfTrilinear(vec3 position, ivec3 n)
{
    ProbeCell cell = probeCell(position, n);
    float sum = 0.0f;
    for (int c = 0; c < 8; ++c) sum += probeTrilinear(cell, c);
    return sum;
}
// What the probes give at a position when probe (i, j, k) holds a linear function of its own position.
float linear(vec3 position, ivec3 n)
{
    ProbeCell cell = probeCell(position, n);
    float sum = 0.0f;
    for (int c = 0; c < 8; ++c) {
        vec3 p = probeUnitPosition(probeCorner(cell, c, n), n);
        sum += probeTrilinear(cell, c) * (1.0f + 2.0f * p.x - 3.0f * p.y + 0.5f * p.z);
    }
    return sum;
}
}

TEST(Probe, InterpolationIsExactForLinearFields)
{
    Random random;
    for (int i = 0; i < 5000; ++i) {
        vec3 p = vec3(random.next(), random.next(), random.next()) - 0.5f;
        EXPECT_NEAR(sumOfTrilinear(p, ivec3(5, 3, 4)), 1.0f, 1e-5f);
        EXPECT_NEAR(linear(p, ivec3(5, 3, 4)), 1.0f + 2.0f * p.x - 3.0f * p.y + 0.5f * p.z, 1e-4f);
    }
    EXPECT_NEAR(linear(vec3(0.5f), ivec3(5, 3, 4)), 1.0f + 1.0f - 1.5f + 0.25f, 1e-5f); // the border itself
}

TEST(Probe, OneProbeOnAnAxisIsConstantAlongIt)
{
    for (float y : {-0.5f, -0.2f, 0.0f, 0.5f, 7.0f}) EXPECT_NEAR(linear(vec3(0.25f, y, 0.0f), ivec3(5, 1, 3)), 1.5f, 1e-5f);
    EXPECT_EQ(probeUnitPosition(ivec3(0), ivec3(1)), vec3(0.0f));
    EXPECT_NEAR(sumOfTrilinear(vec3(0.1f), ivec3(1)), 1.0f, 1e-6f);
}

TEST(Probe, OutsideIsTheBorder)
{
    EXPECT_NEAR(linear(vec3(9, 0, 0), ivec3(4)), linear(vec3(0.5f, 0, 0), ivec3(4)), 1e-6f);
    EXPECT_NEAR(linear(vec3(-9, -9, -9), ivec3(4)), linear(vec3(-0.5f), ivec3(4)), 1e-6f);
    ProbeCell cell = probeCell(vec3(std::nanf("")), ivec3(4));
    EXPECT_TRUE(cell.lower.x >= 0 && cell.lower.x < 4 && std::isfinite(cell.fraction.x));
}

TEST(Probe, IndexRunsXThenYThenZ) { EXPECT_EQ(probeIndex(ivec3(1, 2, 3), ivec3(4, 5, 6)), 1 + 4 * (2 + 5 * 3)); }

TEST(Probe, WeightsDropWhatIsInvalidOrBehind)
{
    vec3 n(0, 1, 0);
    EXPECT_EQ(probeWeight(0.5f, 0.0f, vec3(0, 1, 0), n), 0.0f);
    EXPECT_GT(probeWeight(0.5f, 1.0f, vec3(0, 1, 0), n), 10.0f * probeWeight(0.5f, 1.0f, vec3(0, -1, 0), n));
    EXPECT_GT(probeWeight(0.5f, 1.0f, vec3(0, -1, 0), n), 0.0f);
    EXPECT_GT(probeWeight(0.5f, 1.0f, vec3(0), n), 0.0f); // on the probe itself
}

// Half-way between probes at 0 and s, of E(x) = (1 + x^2)^(-3/2): the error of linear interpolation falls with s^2.
TEST(Probe, TrilinearErrorIsQuadratic)
{
    struct Row {
        double s, error;
    };
    auto e = [](double x) { return std::pow(1.0 + x * x, -1.5); };
    for (const Row& r : {Row{0.5, 0.05530441785}, Row{0.25, 0.0204744161}, Row{0.125, 0.005663073802}}) {
        ProbeCell cell = probeCell(vec3(0.0f), ivec3(2, 1, 1)); // the middle of two
        double value = 0.0;
        for (int c = 0; c < 8; ++c) {
            vec3 p = probeUnitPosition(probeCorner(cell, c, ivec3(2, 1, 1)), ivec3(2, 1, 1));
            value += double(probeTrilinear(cell, c)) * e((double(p.x) + 0.5) * r.s);
        }
        expectRelative(e(0.5 * r.s) - value, r.error, 1e-5);
    }
}

TEST(Probe, ChebyshevVisibility)
{
    expectRelative(chebyshevVisibility(2.0f, 0.25f, 3.0f), 0.2, 1e-5);
    EXPECT_EQ(chebyshevVisibility(2.0f, 0.25f, 1.5f), 1.0f);
    EXPECT_EQ(chebyshevVisibility(2.0f, 0.0f, 2.5f), 0.0f);
    EXPECT_EQ(chebyshevVisibility(2.0f, -1.0f, 2.5f), 0.0f); // a rounded-off variance
}
}
