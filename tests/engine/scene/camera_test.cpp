// Cameras: by name, by index, the first, or one that sees the whole level.
#include "shaders/camera.h"
#include "tests/engine/scene/builder.hpp"

namespace afterglow::test
{
class CameraTest : public LevelTest
{
protected:
    void camera(const char* name, json source, json placed = json::object())
    {
        placed["camera"] = add("cameras", std::move(source));
        placed["name"] = name;
        node(std::move(placed));
    }
    static json perspective(double yfov = 0.8, double znear = 0.05)
    {
        return {{"type", "perspective"}, {"perspective", {{"yfov", yfov}, {"znear", znear}, {"aspectRatio", 1.5}}}};
    }
};

TEST_F(CameraTest, StandsWhereItsNodeStands)
{
    camera("Hall", perspective(), {{"translation", {1, 2, 3}}, {"scale", {4, 4, 4}}});
    const Camera hall = load().cameras.at(0);
    EXPECT_EQ(hall.name, "Hall");
    EXPECT_FLOAT_EQ(hall.fovY, 0.8f);
    EXPECT_EQ(hall.nearPlane, 0.05f);
    EXPECT_EQ(vec3(hall.toWorld[3]), vec3(1, 2, 3));
    EXPECT_TRUE(near(vec3(hall.toWorld[2]), {0, 0, 1})); // the scale is taken off
}

TEST_F(CameraTest, MayBeOrthographic)
{
    camera("Plan", {{"type", "orthographic"}, {"orthographic", {{"xmag", 4}, {"ymag", 2}, {"znear", 0.1}, {"zfar", 100}}}});
    const Camera plan = load().cameras.at(0);
    EXPECT_EQ(plan.fovY, 0.0f);
    EXPECT_EQ(plan.orthoHeight, 4.0f);
}

// The file's aspect, 1.5 here, has no say: at (x, y, -1) with y = tan(yfov / 2) the picture's upper edge is met, and its side at
// x = y * width / height.
TEST_F(CameraTest, SeesAsWideAsThePictureIs)
{
    camera("Hall", perspective());
    const Camera hall = load().cameras.at(0);
    for (const uvec2 picture : {uvec2(64, 32), uvec2(32, 64), uvec2(48, 48)}) {
        const float y = std::tan(0.4f), x = y * float(picture.x) / float(picture.y);
        const vec4 corner = projection(hall, picture) * vec4(x, y, -1, 1);
        EXPECT_NEAR(corner.x, corner.w, 1e-5f);
        EXPECT_NEAR(corner.y, -corner.w, 1e-5f);
    }
}

TEST_F(CameraTest, IsFoundByNameOrIndex)
{
    camera("Hall", perspective());
    camera("1", perspective(0.5));
    camera("Wing", perspective(0.6));
    const Scene scene = load();
    EXPECT_EQ(findCamera(scene, "").name, "Hall");
    EXPECT_EQ(findCamera(scene, "Wing").name, "Wing");
    EXPECT_EQ(findCamera(scene, "1").name, "1"); // a name goes before an index
    EXPECT_EQ(findCamera(scene, "2").name, "Wing");
    try {
        findCamera(scene, "Roof");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()), "level.glb has no camera \"Roof\"; it has Hall, 1, Wing");
    }
    EXPECT_THROW(findCamera(scene, "3"), Error);
    EXPECT_THROW(findCamera(scene, "-1"), Error);
}

// Every corner of the level's box lies inside the picture, at any place and size.
TEST_F(CameraTest, SeesTheWholeLevelWhenThereIsNone)
{
    place(primitive({0, 0, 0, 1, 0, 0, 0, 1, 1}), {{"translation", {100, -7, 3}}, {"scale", {8, 3, 40}}});
    const Scene scene = load();
    const Camera camera = findCamera(scene, "");
    const mat4 clip = perspectiveReversed(camera.fovY, 1.0f, camera.nearPlane) * inverse(camera.toWorld);
    for (int corner = 0; corner < 8; ++corner) {
        const vec4 p = clip * vec4(corner & 1 ? scene.upper.x : scene.lower.x, corner & 2 ? scene.upper.y : scene.lower.y,
                                   corner & 4 ? scene.upper.z : scene.lower.z, 1);
        EXPECT_LT(std::abs(p.x), p.w);
        EXPECT_LT(std::abs(p.y), p.w);
        EXPECT_GT(p.w, camera.nearPlane);
    }
}

TEST_F(CameraTest, OfAnEmptyLevelIsFinite)
{
    const Camera camera = findCamera(load(), "");
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) EXPECT_TRUE(std::isfinite(camera.toWorld[c][r]));
}

// H66 begins here: what no picture can be made with is not offered.
TEST_F(CameraTest, ThatMakesNoPictureIsLeftOut)
{
    camera("Near", perspective(0.8, 0.0));
    camera("Narrow", perspective(0.0));
    camera("Wide", perspective(3.2));
    camera("Flat", perspective(), {{"scale", {1, 1, 0}}});
    camera("Inverted", {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 5}, {"zfar", 1}}}});
    const Scene scene = load();
    EXPECT_TRUE(scene.cameras.empty());
    EXPECT_EQ(count(scene, "cameras that make no picture"), 5);
    EXPECT_NE(droppedText(scene).find("cameras that make no picture (5)"), std::string::npos);
    try {
        findCamera(scene, "Flat");
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("left out"), std::string::npos) << error.what();
    }
}
}
