// What counts as a solid's inside: where no light is, and not merely where backs are seen.
#include "baker/probes.hpp"
#include "baker/solids.hpp"
#include "engine/baked/probe_read.hpp"
#include "shapes.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
// A lamp in a closed room whose faces look inwards, or all outwards; a block in it; an open sheet over its floor, back down.
static Scene room(bool insideOut)
{
    Scene scene;
    add(scene, insideOut ? box(vec3(4.0f)) : flipped(box(vec3(4.0f))), matte(0.5f));
    add(scene, moved(box(vec3(1.0f)), vec3(1.0f, -1.5f, 1.0f)), matte(0.5f));
    add(scene, plate(vec3(-1.0f, -1.5f, -1.0f), 0.5f), matte(0.5f));
    scene.lower = vec3(-2.0f), scene.upper = vec3(2.0f);
    Light lamp{};
    lamp.intensity = vec3(1.0f);
    scene.lights = {lamp};
    return scene;
}

TEST(Solids, areBodiesWhoseInsideIsDark)
{
    for (bool insideOut : {false, true}) {
        Scene scene = room(insideOut);
        World world(scene, Content::staticOnly);
        Solids solids(LightTransport(world, scene.lights));
        auto startsInside = [&](vec3 from, vec3 along) {
            Ray ray{from, normalize(along), kRayFar};
            return solids.meetsInside(ray, world.closestHit(ray));
        };
        EXPECT_TRUE(startsInside(vec3(1.0f, -1.5f, 1.0f), vec3(0.3f, 1.0f, 0.2f))) << "within the block";
        EXPECT_FALSE(startsInside(vec3(0.0f), vec3(-1.0f, 0.1f, 0.2f))) << "towards a wall";
        EXPECT_FALSE(startsInside(vec3(-1.0f, -1.9f, -1.0f), vec3(0.1f, 1.0f, 0.1f))) << "towards the back of the sheet";
        EXPECT_FALSE(startsInside(vec3(0.0f), vec3(1.0f, -1.5f, 1.0f))) << "towards the block, from outside";
    }
}

TEST(Solids, leaveTheProbesOfARoomThatIsInsideOutValid)
{
    vec3 irradiance[2];
    for (bool insideOut : {false, true}) {
        Scene scene = room(insideOut);
        World world(scene, Content::staticOnly);
        LightTransport transport(world, scene.lights);
        Progress silent(ProgressStyle::none);
        BakeContext context(transport, Solids(transport), scene.lights, silent);
        const ProbesResult probes = bakeProbes(context, {.spacing = 2.0, .samples = 4096});
        ASSERT_FALSE(probes.tree.empty());
        irradiance[insideOut] = probeLookup(ProbeSet{&probes.tree}, vec3(-1.0f, 0.5f, -1.0f), vec3(0.0f, 1.0f, 0.0f));
    }
    EXPECT_GT(irradiance[0].x, 0.02f);
    EXPECT_NEAR(irradiance[1].x, irradiance[0].x, 0.05f * irradiance[0].x);
}

// What is sunk into a block hides most of its walls from a point between them: that lies in the block all the same, and no probe stands there.
TEST(Solids, holdPointsAmongWhatIsSunkIntoThem)
{
    Scene scene;
    add(scene, moved(box(vec3(4.0f, 1.0f, 4.0f)), vec3(0.0f, -0.5f, 0.0f)), matte(0.5f));
    for (float x : {-0.5f, 0.5f})
        for (float z : {-0.5f, 0.5f}) add(scene, moved(box(vec3(0.7f)), vec3(x, -0.3f, z)), matte(0.5f));
    scene.sky.radiance = vec3(1.0f);
    scene.lower = vec3(-2.0f, -1.0f, -2.0f), scene.upper = vec3(2.0f, 0.2f, 2.0f);
    World world(scene, Content::staticOnly);
    LightTransport transport(world, scene.lights);
    const Solids solids(transport);
    const vec3 within(0.0f, -0.3f, 0.0f);
    EXPECT_LT(solids.shareInside(within), 0.5) << "more of the sunken is seen than of the block";
    EXPECT_TRUE(solids.hold(within));
    for (const vec3 open : {vec3(0.0f, 0.02f, 0.0f), vec3(0.5f, 0.06f, 0.5f), vec3(0.02f, -0.3f, 2.001f)})
        EXPECT_EQ(solids.shareInside(open), 0.0);
}
}
