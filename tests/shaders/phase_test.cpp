// Henyey-Greenstein at every g, delta ends included: value, sampler, moments.
#include "shaders/phase.h"
#include "tests/shaders/statistics.hpp"

namespace afterglow::test
{
TEST(Phase, MeetsItsValues)
{
    struct Row {
        double g, cosine, value;
    };
    for (const Row& r : {Row{0.0, 0.3, 0.07957747155}, Row{0.5, 1.0, 0.4774648293}, Row{0.5, -1.0, 0.01768388257},
                         Row{-0.5, 1.0, 0.01768388257}, Row{0.9, 0.5, 0.01741733273}})
        expectRelative(phaseHg(float(r.g), float(r.cosine)), r.value, 1e-5);
    // Next to a delta the value follows (1 - g)^-2 or (1 - g), and 0.999 is no float: 0.99900001287 moves it by 2.6e-5 or 1.3e-5 of itself.
    // So the formula, in double, is held against the value, and the law against the formula at the g that it is given.
    auto exact = [](double g, double c) { return (1.0 - g * g) / (4.0 * M_PI * std::pow(1.0 + g * g - 2.0 * g * c, 1.5)); };
    for (const Row& r : {Row{0.999, 1.0, 159075.3656}, Row{0.999, 0.0, 5.632606062e-05}, Row{-0.999, 1.0, 1.991427719e-05}}) {
        expectRelative(exact(r.g, r.cosine), r.value, 1e-8);
        expectRelative(phaseHg(float(r.g), float(r.cosine)), exact(double(float(r.g)), r.cosine), 1e-5);
    }
    expectRelative(phaseHg(0.999f, 1.0f), 159079.463, 1e-6); // of that float itself
}

TEST(Phase, SampledCosineMeetsItsValues)
{
    struct Row {
        double xi, g, cosine;
    };
    for (const Row& r : {Row{0.25, 0.5, 0.25}, Row{0.5, 0.0, 0.0}, Row{0.5, 1e-6, 1.5e-6}, Row{0.001, 0.999, 0.7774816297},
                         Row{0.999, -0.999, -0.7774816297}, Row{0.25, 1e-7, -0.499999887}, Row{0.9, 1e-5, 0.8000054}, Row{0.0, 0.999, -1.0},
                         Row{0.5, -1.0, -1.0}, Row{0.5, 1.0, 1.0}})
        EXPECT_NEAR(sampleHgCos(float(r.g), float(r.xi)), r.cosine, 1e-5 * std::abs(r.cosine) + 1e-7) << r.g << " " << r.xi;
}

TEST(Phase, IsNearlyIsotropicForTinyG)
{
    for (float g : {0.0f, 1e-7f, -1e-7f})
        for (int i = 0; i <= 100; ++i) {
            float xi = std::min(float(i) / 100.0f, 1.0f - 1.0f / 16777216.0f);
            EXPECT_NEAR(sampleHgCos(g, xi), 2.0f * xi - 1.0f, 1e-6f);
            EXPECT_NEAR(phaseHg(g, 2.0f * xi - 1.0f), kInvFourPi, 1e-6f);
        }
}

TEST(Phase, MomentsAndForwardShare)
{
    struct Row {
        double g, square;
    };
    for (const Row& r :
         {Row{0.5, 0.5}, Row{0.999, 0.9986673333}, Row{-0.999, 0.9986673333}, Row{0.0, 1.0 / 3.0}, Row{-0.3, 0.3933333333}}) {
        Random random;
        Mean cosine, square, forward;
        for (int i = 0; i < 400000; ++i) {
            double c = double(sampleHgCos(float(r.g), random.next()));
            cosine.add(c);
            square.add(c * c);
            forward.add(c > 0.0 ? 1.0 : 0.0);
        }
        EXPECT_NEAR(cosine.value(), r.g, 4.0 * cosine.error() + 1e-5 * std::abs(r.g));
        EXPECT_NEAR(square.value(), r.square, 4.0 * square.error() + 1e-5 * r.square);
        EXPECT_NEAR(forward.value(), phaseHgForward(float(r.g)), 4.0 * forward.error() + 1e-6);
    }
    expectRelative(phaseHgForward(0.5f), 0.8291796068, 1e-6);
    expectRelative(phaseHgForward(0.999f), 0.999792686, 1e-6);
    EXPECT_EQ(phaseHgForward(0.0f), 0.5f);
}

TEST(Phase, IntegratesToOneAndItsSamplesFollowIt)
{
    for (float g : {0.0f, 0.3f, -0.6f, 0.85f}) {
        EXPECT_NEAR(overSphere([&](vec3 d) { return double(phaseHg(g, d.z)); }, -1.0, 1.0, 20000, 1), 1.0, 2e-5);
        double deviation = directionChiSquare(
            [&](Random& r, vec3& d) {
                PhaseSample s = samplePhaseHg(g, r.next2());
                d = s.direction;
                EXPECT_NEAR(s.pdf, phaseHg(g, d.z), 2e-4f * s.pdf);
                return true;
            },
            [&](vec3 d) { return double(phaseHg(g, d.z)); }, 100000);
        EXPECT_LT(deviation, 4.0) << g;
    }
}

// H41
TEST(Phase, EndsAreSafe)
{
    for (float g : {-1.0f, -0.999f, 0.0f, 0.999f, 1.0f})
        for (float xi : {0.0f, 0.5f, 1.0f - 1.0f / 16777216.0f}) {
            PhaseSample s = samplePhaseHg(g, vec2(xi, xi));
            EXPECT_NEAR(length(s.direction), 1.0f, 1e-5f);
            EXPECT_TRUE(std::isfinite(s.pdf) && s.pdf >= 0.0f);
        }
    EXPECT_EQ(samplePhaseHg(1.0f, vec2(0.3f)).direction.z, 1.0f);
    EXPECT_EQ(samplePhaseHg(-1.0f, vec2(0.3f)).direction.z, -1.0f);
}
}
