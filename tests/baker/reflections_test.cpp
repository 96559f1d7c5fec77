// Reflection probes: where they stand, and that blurring neither makes nor loses light.
#include "baker/reflections.hpp"
#include "rooms.hpp"
#include "shaders/reflection.h"
#include <gtest/gtest.h>

namespace afterglow
{
// H88: a constant environment is the same through all mips and faces, edges included.
TEST(Reflections, ofAConstantEnvironmentAreConstant)
{
    Scene scene;
    scene.sky.radiance = vec3(0.7f, 0.1f, 30.0f);
    Bakery bakery(scene);
    std::vector<ReflectionProbe> probes(2);
    const float error = bakeReflections(bakery.context, probes, 32, 4);
    EXPECT_LT(error, 1e-6f);
    for (const ReflectionProbe& probe : probes) {
        ASSERT_EQ(probe.mips.size(), 4u); // 32 16 8 4
        for (std::size_t mip = 0; mip < probe.mips.size(); mip++) {
            ASSERT_EQ(probe.mips[mip].size(), std::size_t(6 * (32 >> mip) * (32 >> mip)));
            for (vec3 texel : probe.mips[mip])
                for (int c = 0; c < 3; c++) ASSERT_NEAR(texel[c], scene.sky.radiance[c], 1e-3f * scene.sky.radiance[c]) << mip;
        }
    }
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

TEST(Reflections, standWhereTheLevelSays)
{
    Scene scene = furnace(0.5f);
    scene.reflectionProbes = {{"by hand", vec3(0.1f, 0.2f, 0.3f), vec3(1.0f, 2.0f, 3.0f)}};
    Bakery bakery(scene);
    const std::vector<ReflectionProbe> placed = placeReflections(bakery.world, {}, 8);
    ASSERT_EQ(placed.size(), 1u);
    EXPECT_EQ(placed[0].name, "by hand");
    EXPECT_EQ(placed[0].boxLower, vec3(-0.9f, -1.8f, -2.7f));
    EXPECT_EQ(placed[0].boxUpper, vec3(1.1f, 2.2f, 3.3f));
}

// Among irradiance probes: the widest view first, none near another. The proxy box is the room.
TEST(Reflections, standWhereTheViewIsWidest)
{
    Scene scene;
    addSurface(scene, flipped(box(vec3(20.0f, 4.0f, 6.0f))), shining(1.0f));
    scene.lower = vec3(-10, -2, -3), scene.upper = vec3(10, 2, 3);
    Bakery bakery(scene);
    ProbesResult probes;
    for (float x : {-8.0f, -4.0f, 4.0f, 8.0f}) probes.tree.positions.push_back(vec3(x, 0, 0));
    probes.clearance = {3.0f, 3.5f, 2.0f, 1.0f};

    const std::vector<ReflectionProbe> placed = placeReflections(bakery.world, probes, 8);
    ASSERT_EQ(placed.size(), 2u); // -4; then 4, since -8 is no more than 4 m from -4; 8 is as near to 4
    EXPECT_NEAR(placed[0].position.x, -4.0f, 1e-5f);
    EXPECT_NEAR(placed[1].position.x, 4.0f, 1e-5f);
    for (const ReflectionProbe& probe : placed)
        for (int axis = 0; axis < 3; axis++) {
            EXPECT_NEAR(probe.boxLower[axis], scene.lower[axis], 1e-3f);
            EXPECT_NEAR(probe.boxUpper[axis], scene.upper[axis], 1e-3f);
        }
    EXPECT_EQ(placeReflections(bakery.world, probes, 1).size(), 1u);
}
}
