// Reflection probes: that blurring neither makes nor loses light, that faces have no seams, and that probes blend without a step.
#include "baker/cube.hpp"
#include "baker/reflections.hpp"
#include "rooms.hpp"
#include "shaders/sampling.h"
#include <gtest/gtest.h>

namespace afterglow
{
// The twelve edges of a cube and its eight corners, as pairs of directions that lie on faces which meet there.
template <class Visit>
static void acrossEdges(Visit visit)
{
    constexpr float kStep = 1e-5f;
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++)
            for (const float sideA : {-1.0f, 1.0f})
                for (const float sideB : {-1.0f, 1.0f})
                    for (const float along : {-0.999f, -0.6f, 0.03f, 0.41f, 1.0f}) {
                        if (a == b) continue;
                        vec3 here(along), there(along);
                        here[a] = there[a] = sideA, here[b] = there[b] = sideB;
                        here[a] *= 1.0f + kStep, there[b] *= 1.0f + kStep;
                        visit(normalize(here), normalize(there));
                    }
}

// H88: a constant environment is the same through all mips and faces, whatever the direction and the roughness, edges and corners included.
TEST(Reflections, ofAConstantEnvironmentAreConstant)
{
    Scene scene;
    scene.sky.radiance = vec3(0.7f, 0.1f, 30.0f);
    Bakery bakery(scene);
    std::vector<ReflectionProbe> probes(2);
    const float error = bakeReflections(bakery.context, probes, 32, 4);
    EXPECT_LT(error, 1e-6f);
    const auto expectSky = [&](vec3 seen, float where) {
        for (int c = 0; c < 3; c++) ASSERT_NEAR(seen[c], scene.sky.radiance[c], 1e-3f * scene.sky.radiance[c]) << where;
    };
    for (const ReflectionProbe& probe : probes) {
        ASSERT_EQ(probe.mips.size(), 4u); // 32 16 8 4
        for (std::size_t mip = 0; mip < probe.mips.size(); mip++) {
            ASSERT_EQ(probe.mips[mip].size(), std::size_t(6 * (32 >> mip) * (32 >> mip)));
            for (vec3 texel : probe.mips[mip]) expectSky(texel, float(mip));
        }
        for (const float roughness : {0.0f, 0.15f, 1.0f / 3.0f, 0.5f, 0.9f, 1.0f})
            acrossEdges([&](vec3 here, vec3 there) {
                expectSky(cubeRadiance(probe, here, roughness), roughness);
                expectSky(cubeRadiance(probe, there, roughness), roughness);
            });
    }
}

// Texels as different as can be: what is read on two sides of an edge is still the same, but for the step between them.
TEST(Reflections, haveNoSeamsBetweenFaces)
{
    ReflectionProbe probe;
    probe.size = 16;
    for (int edge = 16; edge >= 1; edge /= 2) {
        std::vector<vec3>& mip = probe.mips.emplace_back();
        for (int i = 0; i < 6 * edge * edge; i++) mip.push_back(vec3(hashFloat(uint(i)), hashFloat(uint(i) + 7919u), float(i % 2)));
    }
    for (const float roughness : {0.0f, 0.25f, 0.6f, 1.0f})
        acrossEdges([&](vec3 here, vec3 there) {
            const vec3 a = cubeRadiance(probe, here, roughness), b = cubeRadiance(probe, there, roughness);
            for (int c = 0; c < 3; c++) ASSERT_NEAR(a[c], b[c], 1e-3f) << roughness << " " << here.x << " " << here.y << " " << here.z;
        });
}

// What shines on one side is seen on that side: sharp in the first mip; in the last one still brighter there, and dimmer than 1.
TEST(Reflections, seeTheRoomFromTheirPlace)
{
    Bakery bakery(halfLitRoom());
    std::vector<ReflectionProbe> probes(1);
    bakeReflections(bakery.context, probes, 16, 4);
    const auto faceMean = [&](std::size_t mip, int face) {
        const int edge = 16 >> mip;
        double sum = 0.0;
        for (int i = 0; i < edge * edge; i++) sum += double(probes[0].mips[mip][std::size_t(face * edge * edge + i)].x);
        return sum / (edge * edge);
    };
    EXPECT_DOUBLE_EQ(faceMean(0, 0), 1.0);
    EXPECT_DOUBLE_EQ(faceMean(0, 1), 0.0);
    for (int face = 2; face < 6; face++) EXPECT_NEAR(faceMean(0, face), 0.5, 1e-6) << face; // cut down the middle, between two texels
    const std::size_t last = probes[0].mips.size() - 1;
    EXPECT_LT(faceMean(last, 0), 1.0);
    EXPECT_GT(faceMean(last, 0), 0.75);
    EXPECT_LT(faceMean(last, 1), 0.25);
}

static ReflectionProbe evenProbe(vec3 position, vec3 lower, vec3 upper, float radiance)
{
    return {.position = position, .boxLower = lower, .boxUpper = upper, .size = 1, .mips = {std::vector<vec3>(6, vec3(radiance))}};
}

// Boxes beside, over and within each other: weights sum to 1 with what none covers, and a point that moves sees no step.
TEST(Reflections, blendWithoutAStep)
{
    std::vector<ReflectionProbe> probes = {evenProbe(vec3(1, 1, 1), vec3(0), vec3(4, 3, 3), 1.0f),
                                           evenProbe(vec3(5, 2, 1), vec3(3.5f, 0, 0), vec3(8, 3, 3), 2.0f),
                                           evenProbe(vec3(2, 1, 2), vec3(1.5f, 0.5f, 1.5f), vec3(2.5f, 1.5f, 2.5f), 4.0f)};
    std::vector<ReflectionProbe> ones = probes;
    for (ReflectionProbe& probe : ones) probe.mips[0].assign(6, vec3(1.0f));
    constexpr int kSteps = 20000;
    for (uint line = 0; line < 20; line++) {
        const auto corner = [&](uint i) {
            return mix(vec3(-1.0f), vec3(9.0f, 4.0f, 4.0f), vec3(hashFloat(i), hashFloat(i + 1), hashFloat(i + 2)));
        };
        const vec3 from = corner(10 * line), to = corner(10 * line + 5);
        float before = -1.0f;
        for (int i = 0; i <= kSteps; i++) {
            const vec3 p = mix(from, to, float(i) / kSteps);
            EXPECT_NEAR(reflectedRadiance(ones, p, vec3(0, 1, 0), 0.3f, vec3(1.0f)).x, 1.0f, 1e-5f);
            const float seen = reflectedRadiance(probes, p, vec3(0, 1, 0), 0.3f, vec3(0.0f)).x;
            // A ramp is a tenth of a metre at least, and no two values differ by more than 4: 40 / m, and what nearness adds about a probe
            const float step = i > 0 ? std::abs(seen - before) : 0.0f;
            ASSERT_LT(step, 100.0f * distance(from, to) / kSteps) << p.x << " " << p.y << " " << p.z;
            before = seen;
        }
    }
    EXPECT_EQ(reflectedRadiance(probes, vec3(9, 1, 1), vec3(0, 1, 0), 0.3f, vec3(7.0f)).x, 7.0f); // no box is near
}
}
