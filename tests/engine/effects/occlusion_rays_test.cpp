// Occlusion by ray query against closed forms: walls, wedges, a pit; what the screen does not see hides, too, and by the share that it
// stops.
#include "shaders/formfactor.h"
#include "shaders/penumbra.h"
#include "tests/engine/effects/drawn.hpp"

namespace afterglow
{
class OcclusionRays : public Drawn
{
protected:
    void SetUp() override
    {
        if (!gpu.device.rayQuery) GTEST_SKIP() << gpu.device.deviceName << " has no ray queries";
        size = {33, 33}; // a pixel whose centre is the axis
        parameters.rays = 64;
        parameters.divisor = 1;
    }
    uint grey() { return scene.materials.empty() ? addMaterial(scene, matte(vec3(0.64f))) : 0u; }
    void floor() { addQuad(scene, vec3(-50, 0, -50), vec3(0, 0, 100), vec3(100, 0, 0), grey()); }
    // Over `at`, a spot so small that visibility is even on it: 16 neighbours together see one set of 1024 directions.
    float seen(vec3 at, vec3 from) { return middle(visibility(lookAt(from, at, 0.002f), OcclusionMethod::ray, parameters)).x; }
    OcclusionParameters parameters = defaultOcclusionParameters();
};

// Edges of 1024 stratified points: .00307 RMSE (stratified, cost laws); four of that, and a half float's rounding.
constexpr float kError = 4.0f * 0.00307f + 0.0005f;

TEST_F(OcclusionRays, AFloorIsOpenToTheLastRay)
{
    floor();
    for (const float height : {0.2f, 1.7f, 20.0f, 900.0f}) {
        const Image image = visibility(lookAt(vec3(0, height, 4), vec3(0)), OcclusionMethod::ray, defaultOcclusionParameters());
        for (int i = 0; i < image.width * image.height; ++i) ASSERT_EQ(image.pixels[std::size_t(i) * image.channels], 1.0f) << height;
    }
}

// In a picture of few pixels a triangle that is drawn a little beside its place lies far off it.
TEST_F(OcclusionRays, AFloorWithSnappedCornersIsOpen)
{
    floor();
    size = {16, 16};
    for (const vec2 off : furthestOff()) {
        cornersOff = off;
        const Image image = visibility(lookAt(vec3(0, 1.7f, 4), vec3(0)), OcclusionMethod::ray, defaultOcclusionParameters());
        for (int i = 0; i < image.width * image.height; ++i)
            ASSERT_EQ(image.pixels[std::size_t(i) * image.channels], 1.0f) << off.x << ' ' << off.y;
    }
}

// ao.wall_range: a wall at a distance of t ranges hides 1 - penumbra(t).
TEST_F(OcclusionRays, AWallHidesWhatTheRangeReaches)
{
    floor();
    addQuad(scene, vec3(0, 0, -50), vec3(0, 50, 0), vec3(0, 0, 100), grey());
    parameters.range = 2.0f;
    for (const float t : {0.1f, 0.3f, 0.5f, 1.1f}) EXPECT_NEAR(seen(vec3(2 * t, 0, 0), vec3(2 * t, 1.5f, 0)), penumbra(t), kError) << t;
}

// A plane that rises from the floor at an angle leaves (1 - cos) / 2 of the light.
TEST_F(OcclusionRays, AWedgeHidesByItsAngle)
{
    for (const float degrees : {60.0f, 90.0f, 135.0f}) {
        scene.vertices.clear(), scene.indices.clear(), scene.meshes.clear(), scene.objects.clear();
        floor();
        const float angle = degrees * kPi / 180.0f;
        addQuad(scene, vec3(0, 0, -500), vec3(std::cos(angle), std::sin(angle), 0) * 500.0f, vec3(0, 0, 1000), grey());
        parameters.range = 1000.0f;
        // From within the wedge, straight at the floor or along the plane
        const vec3 from = vec3(0.5f, 0, 0) + vec3(std::cos(0.5f * angle), std::sin(0.5f * angle), 0) * 0.5f;
        EXPECT_NEAR(seen(vec3(0.5f, 0, 0), from), 0.5f * (1.0f - std::cos(angle)), kError) << degrees;
    }
}

// ao.pit: the floor's middle of a square well, half width a and depth h, sees what its mouth subtends.
TEST_F(OcclusionRays, APitSeesItsMouth)
{
    addQuad(scene, vec3(-1, 0, -1), vec3(0, 0, 2), vec3(2, 0, 0), grey());
    for (const vec3 side : {vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0, 0, 1), vec3(0, 0, -1)}) {
        const vec3 along = cross(side, vec3(0, 1, 0));
        addQuad(scene, side - along, 2.0f * along, vec3(0, 1, 0), 0);
    }
    parameters.range = 100.0f;
    EXPECT_NEAR(seen(vec3(0), vec3(0, 0.9f, 0)), 4.0f * parallelRectangleFormFactor(1, 1), kError);
}

// A lid behind the eye: no depth buffer holds it. Of an endless one at half the range, rays within 60 degrees of the normal meet it in
// time: sin^2 60 = 0.75 of the light.
TEST_F(OcclusionRays, WhatTheScreenDoesNotSeeHides)
{
    floor();
    addQuad(scene, vec3(-9, 0.5f, -9), vec3(18, 0, 0), vec3(0, 0, 18), grey());
    EXPECT_NEAR(seen(vec3(0), vec3(0, 0.4f, 0)), 0.25f, kError);
    scene.materials.push_back(scene.materials[0]);
    scene.materials[1].flags |= kMaterialAlphaBlend;
    scene.materials[1].baseColor.a = 0.4f;
    scene.meshes.back().primitives.back().material = 1;
    EXPECT_NEAR(seen(vec3(0), vec3(0, 0.4f, 0)), 1.0f - 0.4f * 0.75f, kError) << "a veil hides by its alpha";
}

// H65: the sky is open, and hides nothing.
TEST_F(OcclusionRays, TheSkyIsOpen)
{
    floor();
    EXPECT_EQ(visibility(lookAt(vec3(0, 1, 0), vec3(0, 2, -1)), OcclusionMethod::ray, parameters).at(16, 2)[0], 1.0f);
}
}
