// Interfaces: dielectric, conductor, averages, refraction, and the angles where the naive forms break.
#include "shaders/fresnel.h"
#include "tests/shaders/statistics.hpp"
#include <gtest/gtest.h>

namespace afterglow::test
{
namespace
{
float cosDegrees(double degrees) { return float(std::cos(degrees * M_PI / 180.0)); }
}

TEST(Fresnel, DielectricMeetsItsValues)
{
    struct Row {
        float eta;
        double degrees, value;
    };
    for (const Row& r : {Row{1.5f, 0.0, 0.04}, Row{1.5f, 45.0, 0.05023991101}, Row{1.5f, 56.309932474020215, 0.07396449704},
                         Row{1.5f, 80.0, 0.3877043547}, Row{1.5f, 89.99, 0.9989858952}, Row{2.0f / 3.0f, 30.0, 0.0551901673},
                         Row{2.0f / 3.0f, 41.8, 0.8907719215}, Row{2.0f / 3.0f, 42.0, 1.0}})
        EXPECT_NEAR(fresnelDielectric(cosDegrees(r.degrees), r.eta), r.value, 1e-5 * r.value + 1e-7) << r.eta << " " << r.degrees;
}

// H43: 1e-6 degrees are a third of a step of the cosine in floats, in which the index, too, is rounded: exactly 1 from 1e-4 degrees on.
TEST(Fresnel, IsTotalBeyondTheCriticalAngleAndAbsentBetweenEquals)
{
    double critical = std::asin(1.0 / 1.5) * 180.0 / M_PI;
    for (double off : {1e-6, 1e-3, 1.0}) EXPECT_EQ(fresnelDielectric(cosDegrees(critical + 1e-4 + off), 2.0f / 3.0f), 1.0f);
    for (double off : {-1e-6, 0.0, 1e-6}) {
        float f = fresnelDielectric(cosDegrees(critical + off), 2.0f / 3.0f);
        EXPECT_TRUE(f > 0.98f && f <= 1.0f) << f;
    }
    for (float c : {0.0f, 1e-6f, 1e-3f, 0.5f, 1.0f}) EXPECT_LT(fresnelDielectric(c, 1.0f), 1e-6f);
}

TEST(Fresnel, ConductorMeetsItsValues)
{
    expectRelative(fresnelConductor(1.0f, 0.2f, 3.9f), 0.951951952, 1e-5);
    expectRelative(fresnelConductor(cosDegrees(45.0), 0.2f, 3.9f), 0.9500431802, 1e-5);
    expectRelative(fresnelConductor(cosDegrees(80.0), 0.2f, 3.9f), 0.9484074484, 1e-5);
}

TEST(Fresnel, AveragesMeetTheirValues)
{
    expectRelative(fresnelAverage(1.5f), 0.09177795934, 1e-5);
    expectRelative(fresnelAverage(2.42f), 0.2125407947, 1e-5);
    expectRelative(fresnelAverageInside(1.5f), 0.5963457597, 1e-5);
    expectRelative(fresnelAverageInside(2.42f), 0.8655386918, 1e-5);
    auto schlick = [](float eta) { // F0 + (1 - F0) / 21
        double sum = 0.0;
        for (int i = 0; i < 4096; ++i) {
            double mu = (i + 0.5) / 4096.0;
            sum += 2.0 * mu * double(mix(dielectricF0(eta), 1.0f, schlickWeight(float(mu)))) / 4096.0;
        }
        return sum;
    };
    expectRelative(schlick(1.5f), 0.08571428571, 1e-5);
    expectRelative(schlick(2.42f), 0.2118046904, 1e-5);
    // Near eta = 1 the mean is approximated, from below
    for (float eta : {1.0f, 1.001f, 1.01f, 1.03f, 1.05f, 1.2f, 3.0f}) {
        double mean = 0.0;
        for (int i = 0; i < 20000; ++i) {
            double t = (i + 0.5) / 20000.0; // mu = t^2
            mean += 4.0 * t * t * t * double(fresnelDielectric(float(t * t), eta)) / 20000.0;
        }
        EXPECT_LE(fresnelAverage(eta), mean + 3e-6) << eta;
        EXPECT_GE(fresnelAverage(eta), mean - 7e-4) << eta;
    }
}

TEST(Refraction, BendsAndReportsTotalReflection)
{
    vec3 wo = fromDegrees(45.0f, 0.0f), wi;
    ASSERT_TRUE(refractDirection(wo, vec3(0, 0, 1), 1.5f, wi));
    expectRelative(std::acos(double(-wi.z)) * 180.0 / M_PI, 28.1255057, 1e-5);
    EXPECT_NEAR(length(wi), 1.0f, 1e-6f);
    EXPECT_LT(wi.x, 0.0f);
    EXPECT_FALSE(refractDirection(fromDegrees(60.0f, 0.0f), vec3(0, 0, 1), 1.0f / 1.5f, wi));
    EXPECT_TRUE(refractDirection(wo, vec3(0, 0, 1), 1.0f, wi)); // equal media: straight on
    EXPECT_NEAR(length(wi + wo), 0.0f, 1e-6f);
    // Radiance that enters a denser medium: (1 - F) eta^2
    expectRelative((1.0 - double(fresnelDielectric(wo.z, 1.5f))) * 2.25, 2.1369602, 1e-5);
}
}
