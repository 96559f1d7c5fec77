// Flying: where the eye goes when keys are held and the mouse is dragged.
#include "engine/app/fly.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
static vec3 ahead(const Camera& camera) { return -vec3(camera.toWorld[2]); }

static void expectNear(const vec3& a, const vec3& b) { EXPECT_LT(length(a - b), 1e-5f) << a.x << ' ' << a.y << ' ' << a.z; }

TEST(Fly, KeysMoveAlongTheAxesOfTheEyeAndUpAlongTheWorlds)
{
    Controls controls;
    controls.seconds = 0.25;
    controls.move = {0, 0, 1};
    Camera camera = flown({}, controls, 2.0f); // looks along -z: 2 m/s for a quarter of a second
    expectNear(vec3(camera.toWorld[3]), {0, 0, -0.5f});
    controls.move = {1, 1, 0};
    camera = flown(camera, controls, 2.0f);
    expectNear(vec3(camera.toWorld[3]), {0.5f, 0.5f, -0.5f});
    controls.move = {0, 0, -1};
    controls.fast = true;
    expectNear(vec3(flown(camera, controls, 2.0f).toWorld[3]), {0.5f, 0.5f, 1.5f}); // four times as far, backwards
}

TEST(Fly, AFrameThatTookLongIsNotALeap)
{
    Controls controls;
    controls.seconds = 60;
    controls.move = {0, 0, 1};
    EXPECT_LE(length(vec3(flown({}, controls, 2.0f).toWorld[3])), 0.5f);
}

TEST(Fly, ADragToTheRightLooksRightAndDownLooksDown)
{
    Controls controls;
    controls.look = {100, 0};
    EXPECT_GT(ahead(flown({}, controls, 1.0f)).x, 0.3f);
    controls.look = {0, 100};
    EXPECT_LT(ahead(flown({}, controls, 1.0f)).y, -0.3f);
}

TEST(Fly, StraightUpAndDownTheHeadingIsKept)
{
    for (const float side : {-1.0f, 1.0f}) { // -1: looks straight down, the top of the picture towards +x
        Camera camera;
        camera.toWorld = mat4(vec4(0, 0, 1, 0), vec4(-side, 0, 0, 0), vec4(0, -side, 0, 0), vec4(0, 0, 0, 1));
        Controls controls;
        controls.look = {0, side * 1e-3f};
        camera = flown(camera, controls, 1.0f);
        controls.look = {0, side * 300.0f}; // back towards the horizon
        const vec3 after = ahead(flown(camera, controls, 1.0f));
        EXPECT_GT(after.x, 0.9f);
        EXPECT_NEAR(after.z, 0.0f, 1e-4f);
    }
}

TEST(Fly, TheEyeStaysRigidAndUprightWhateverIsDragged)
{
    Camera camera;
    Controls controls;
    for (int i = 0; i < 1000; ++i) {
        controls.look = {float(i % 37) * 11 - 170, float(i % 23) * 17 - 200};
        camera = flown(camera, controls, 1.0f);
        const vec3 x(camera.toWorld[0]), y(camera.toWorld[1]), z(camera.toWorld[2]);
        EXPECT_NEAR(length(x), 1.0f, 1e-5f);
        EXPECT_NEAR(length(z), 1.0f, 1e-5f);
        expectNear(cross(x, y), z);
        EXPECT_EQ(x.y, 0.0f);
        EXPECT_GT(y.y, 0.0f);
    }
}
}
