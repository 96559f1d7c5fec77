// Single lights: what arrives, from samples and from chance hits, near, far, inside and edge-on; and the sky's map.
#include "shaders/formfactor.h"
#include "shaders/light.h"
#include "tests/shaders/statistics.hpp"

namespace afterglow::test
{
namespace
{
Light point(float intensity, float radius = 0.0f)
{
    Light l{};
    l.type = kLightPoint;
    l.intensity = vec3(intensity);
    l.radius = radius;
    l.direction = vec3(0, 0, -1);
    return l;
}
// Irradiance at `from` about n, by sampling the light.
Mean irradiance(const Light& light, vec3 from, vec3 n, int count = 100000)
{
    Random random;
    Mean mean;
    for (int i = 0; i < count; ++i) {
        LightSample s = sampleLight(light, from, random.next2());
        mean.add(s.pdf > 0.0f ? double(s.radiance.x * std::max(dot(s.direction, n), 0.0f) / s.pdf) : 0.0);
    }
    return mean;
}
}

TEST(PointLight, FallsOffAsItMust)
{
    Light l = point(100.0f * kInvFourPi); // 100 W
    l.position = vec3(0, 0, 2);
    expectRelative(irradiance(l, vec3(0), vec3(0, 0, 1), 10).value(), 1.989436789, 1e-5);
    expectRelative(irradiance(l, vec3(0), fromDegrees(60, 0), 10).value(), 0.9947183943, 1e-5);
    EXPECT_EQ(irradiance(l, vec3(0), fromDegrees(120, 0), 10).value(), 0.0);
    l.range = 4.0f; // the window of KHR_lights_punctual: 1 - (2/4)^4
    expectRelative(irradiance(l, vec3(0), vec3(0, 0, 1), 10).value(), 1.989436789 * (1.0 - 1.0 / 16.0), 1e-5);
    l.range = 1.5f;
    EXPECT_EQ(irradiance(l, vec3(0), vec3(0, 0, 1), 10).value(), 0.0);
}

TEST(PointLight, IsFiniteAtItsOwnPosition)
{
    for (float radius : {0.0f, 0.1f})
        for (float d : {0.0f, 1e-30f, 1e-9f, 0.05f}) {
            Light l = point(1.0f, radius);
            l.position = vec3(d, 0, 0);
            LightSample s = sampleLight(l, vec3(0), vec2(0.3f, 0.6f));
            EXPECT_NEAR(length(s.direction), 1.0f, 1e-5f);
            EXPECT_TRUE(std::isfinite(s.radiance.x) && s.radiance.x > 0.0f && s.pdf > 0.0f && s.distance >= 0.0f);
        }
}

TEST(SpotLight, HasTheRampOfItsCone)
{
    Light l = point(2.0f);
    l.type = kLightSpot;
    l.position = vec3(0, 0, 1);
    l.cosInner = 0.9f;
    l.cosOuter = 0.8f;
    auto at = [&](float cosine) {
        vec3 from = l.position - vec3(std::sqrt(1.0f - cosine * cosine), 0, cosine);
        return sampleLight(l, from, vec2(0.5f)).radiance.x;
    };
    EXPECT_FLOAT_EQ(at(1.0f), 2.0f);
    EXPECT_FLOAT_EQ(at(0.95f), 2.0f);
    EXPECT_NEAR(at(0.85f), 0.5f, 1e-4f); // (1/2)^2
    EXPECT_EQ(at(0.79f), 0.0f);
}

// A sphere of radiance I / (pi R^2) gives the form factor of a sphere, at any tilt.
TEST(SphereLight, GivesItsFormFactor)
{
    for (float h : {1.05f, 2.0f, 10.0f})
        for (float degrees : {0.0f, 60.0f, 80.0f, 100.0f}) {
            Light l = point(3.0f, 0.5f);
            l.position = vec3(0, 0, 0.5f * h);
            double radiance = 3.0 / (M_PI * 0.25);
            Mean mean = irradiance(l, vec3(0), fromDegrees(degrees, 30.0f));
            double truth = M_PI * radiance * double(sphereFormFactor(h, std::cos(degrees * kPi / 180.0f)));
            EXPECT_NEAR(mean.value(), truth, 4.0 * mean.error() + 1e-4 * truth + 1e-6) << h << " " << degrees;
        }
    // Far away it is a point
    Light l = point(3.0f, 0.01f);
    l.position = vec3(0, 0, 1000);
    expectRelative(irradiance(l, vec3(0), vec3(0, 0, 1), 100).value(), 3e-6, 1e-4);
}

TEST(SphereLight, LightsItsInsideEvenly)
{
    Light l = point(1.0f, 2.0f);
    l.position = vec3(0.5f, 0.2f, 0);
    Mean mean = irradiance(l, vec3(0), vec3(0, 1, 0));
    EXPECT_NEAR(mean.value(), 1.0 / 4.0, 4.0 * mean.error()); // pi * I / (pi R^2)
}

// H32: and its density is that of its true solid angle.
TEST(SunDisc, GivesTheIrradianceItWasGiven)
{
    Light sun{};
    sun.type = kLightDirectional;
    sun.direction = normalize(vec3(1, -2, 0.5f));
    sun.intensity = vec3(5.0f);
    for (float degrees : {0.0f, 0.2664531f, 10.0f}) {
        sun.sinAngle = std::sin(degrees * kPi / 180.0f);
        EXPECT_NEAR(irradiance(sun, vec3(7), -sun.direction).value(), 5.0, 5.0 * 2e-3 * double(degrees > 1.0f) + 1e-4);
    }
    sun.sinAngle = std::sin(0.2664531072f * kPi / 180.0f);
    expectRelative(1.0f / sampleLight(sun, vec3(0), vec2(0.5f)).pdf, 6.794310706e-05, 1e-5);
}

// H41: a sphere from far, near and within, a sun, a spot.
TEST(Lights, TheEndsOfTheUnitIntervalAreSafe)
{
    const float last = 1.0f - 1.0f / 16777216.0f;
    Light sphere = point(2.0f, 0.7f), spot = point(2.0f), sun{};
    sphere.position = spot.position = vec3(1, 2, 3);
    spot.type = kLightSpot;
    spot.direction = normalize(-spot.position);
    spot.cosInner = 0.9f, spot.cosOuter = 0.8f;
    sun.type = kLightDirectional;
    sun.direction = vec3(0, -1, 0);
    sun.intensity = vec3(4.0f);
    sun.sinAngle = std::sin(0.2664531f * kPi / 180.0f);
    for (const Light& l : {sphere, spot, sun})
        for (vec3 from : {vec3(0), vec3(1, 2, 3.69999f), vec3(1.2f, 2, 3.1f), vec3(-5e4f, 3, 2)})
            for (float x : {0.0f, 0.5f, last})
                for (float y : {0.0f, 0.5f, last}) {
                    const LightSample s = sampleLight(l, from, vec2(x, y));
                    EXPECT_NEAR(length(s.direction), 1.0f, 1e-5f);
                    EXPECT_GT(s.pdf, 0.0f);
                    EXPECT_TRUE(std::isfinite(s.radiance.x / s.pdf) && s.distance >= 0.0f);
                }
}

// What a sample says of itself is what a ray in its direction finds.
TEST(Lights, ChanceHitsAgreeWithSamples)
{
    Random random;
    Light sphere = point(2.0f, 0.7f), sun{};
    sphere.position = vec3(1, 2, 3);
    sun.type = kLightDirectional;
    sun.direction = vec3(0, -1, 0);
    sun.intensity = vec3(4.0f);
    sun.sinAngle = 0.1f;
    for (const Light& l : {sphere, sun})
        for (vec3 from : {vec3(0), vec3(1.2f, 2, 3.1f), vec3(-50, 3, 2)})
            for (int i = 0; i < 2000; ++i) {
                vec2 u = random.next2() * 0.98f + 0.01f; // not on the rim, where rounding decides
                LightSample s = sampleLight(l, from, u), h = hitLight(l, from, s.direction);
                ASSERT_GT(h.pdf, 0.0f);
                EXPECT_NEAR(h.pdf, s.pdf, 1e-4f * s.pdf);
                EXPECT_NEAR(h.radiance.x, s.radiance.x, 1e-4f * s.radiance.x);
                if (l.type == kLightPoint) {
                    EXPECT_NEAR(h.distance, s.distance, 2e-3f * s.distance + 2e-3f);
                }
                EXPECT_EQ(hitLight(l, vec3(0, 40, 0), vec3(0.6f, 0.0f, 0.8f)).pdf, 0.0f);
            }
    Light delta = point(1.0f);
    delta.position = vec3(0, 0, 1);
    EXPECT_EQ(hitLight(delta, vec3(0), vec3(0, 0, 1)).pdf, 0.0f);
}

TEST(Lights, SamplesFollowTheirDensity)
{
    Light outside = point(1.0f, 1.0f), inside = point(1.0f, 2.0f), sun{};
    outside.position = vec3(0, 0, 2);
    inside.position = vec3(0.5f, 0.2f, 0);
    sun.type = kLightDirectional;
    sun.direction = vec3(0, 0, -1);
    sun.intensity = vec3(1.0f);
    sun.sinAngle = 0.6f;
    auto deviation = [](const Light& l, double low) { // directions above z = low
        return directionChiSquare(
            [&](Random& r, vec3& d) {
                d = sampleLight(l, vec3(0), r.next2()).direction;
                return true;
            },
            [&](vec3 d) { return double(hitLight(l, vec3(0), d).pdf); }, 100000, low);
    };
    EXPECT_LT(deviation(outside, std::sqrt(0.75) - 1e-6), 4.0);
    EXPECT_LT(deviation(inside, -1.0), 4.0);
    EXPECT_LT(deviation(sun, 0.8 - 1e-6), 4.0);
}

TEST(Sky, MapIsItsOwnInverse)
{
    Random random;
    for (float rotation : {0.0f, 1.0f, -2.5f})
        for (int i = 0; i < 5000; ++i) {
            vec3 d = onSphere(2.0 * double(random.next()) - 1.0, 2.0 * M_PI * double(random.next()));
            EXPECT_NEAR(length(skyDirection(skyUv(d, rotation), rotation) - d), 0.0f, 2e-5f);
        }
    EXPECT_NEAR(length(skyUv(vec3(1, 0, 0), 0.0f) - vec2(0.5f, 0.5f)), 0.0f, 1e-6f);
    EXPECT_NEAR(length(skyUv(vec3(0, 0, 1), 0.0f) - vec2(0.75f, 0.5f)), 0.0f, 1e-6f);
    EXPECT_NEAR(skyUv(vec3(0, 1, 0), 0.0f).y, 0.0f, 1e-6f);
    // Turned by +90 degrees about +y, what lay along +x lies along -z
    EXPECT_NEAR(length(skyUv(vec3(0, 0, -1), kHalfPi) - vec2(0.5f, 0.5f)), 0.0f, 1e-6f);
}

TEST(Sky, TexelsCoverTheSphere)
{
    double sum = 0.0;
    for (int row = 0; row < 64; ++row) sum += 128.0 * double(skyTexelSolidAngle(row, 128, 64));
    EXPECT_NEAR(sum, 4.0 * M_PI, 1e-5);
    EXPECT_GT(skyTexelSolidAngle(0, 128, 64), 0.0f);
}
}
