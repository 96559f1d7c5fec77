// Mirrors in whole frames: what they show is held against a picture that needs none, pixel by pixel.
#include "tests/engine/frame/windows.hpp"
#include <set>

namespace afterglow
{
// Without occlusion, which knows what the screen shows and is not drawn behind the mirror.
TEST_F(WindowsTest, AMirrorShowsTheMirroredScene)
{
    const uint water = furnish(mirror());
    settings.effects = parseOverrides("-occlusion");
    const Camera camera = lookAt(vec3(0.2f, 1.3f, 1), vec3(0, 0.4f, -5), 0.9f);
    const std::vector<bool> mask = seen(water, camera);
    EXPECT_GT(std::count(mask.begin(), mask.end(), true), 1000);
    const Image picture = draw(scene, camera);
    EXPECT_EQ(ran("planar.0.geometry"), 1u);
    EXPECT_EQ(differing(picture, draw(upsideDown(), camera), mask), 0);
}

// An orthographic eye from above, at a slant. Without shadows: its own depth, not the mirror's, is too coarse for them.
TEST_F(WindowsTest, SoItDoesForAnOrthographicEye)
{
    const uint water = furnish(mirror());
    settings.effects = parseOverrides("-shadow,-occlusion");
    Camera camera = lookAt(vec3(0.2f, 3, 3), vec3(0, 0.5f, -4));
    camera.fovY = 0.0f;
    camera.orthoHeight = 5.0f;
    const std::vector<bool> mask = seen(water, camera);
    EXPECT_GT(std::count(mask.begin(), mask.end(), true), 700);
    EXPECT_EQ(differing(draw(scene, camera), draw(upsideDown(), camera), mask), 0);
}

// A mirror on the wall, askew: the lamp straight before it is seen at its foot, halfway between the foots of eye and lamp by their
// distances.
TEST_F(WindowsTest, AMirrorImageLiesWherePaperPutsIt)
{
    const vec3 n = normalize(vec3(1, 0.3f, 2)), u = normalize(cross(vec3(0, 1, 0), n)), v = cross(n, u), foot(0, 0, -3);
    addQuad(scene, foot - 3.0f * u - 3.0f * v, 6.0f * u, 6.0f * v, addMaterial(scene, mirror()));
    const vec3 eye = foot + 2.0f * n - 0.5f * u, lamp = foot + 1.0f * n + 1.0f * u + 0.4f * v; // distances 2 and 1 from the mirror
    const vec3 seenAt = mix(eye - 2.0f * n, lamp - n, 2.0f / 3.0f);                            // similar triangles
    Material red = WindowsTest::lamp(vec3(5, 0, 0));
    red.flags = kMaterialLambert; // its front, towards the mirror, alone shines
    addQuad(scene, lamp - 0.02f * (u + v), 0.04f * v, 0.04f * u, addMaterial(scene, red));
    settings.size = {255, 191};
    const Camera camera = lookAt(eye, seenAt + 0.3f * u, 1.0f);
    const Image picture = draw(scene, camera);
    vec2 middle(0.0f);
    float count = 0.0f;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            if (picture.at(x, y)[0] > 4.9f) middle += vec2(x, y) + 0.5f, count += 1.0f;
    ASSERT_GT(count, 3.0f);
    const vec4 clip = makeView(camera, settings.size).worldToClip * vec4(seenAt, 1.0f);
    EXPECT_LT(distance(middle / count, (vec2(clip) / clip.w * 0.5f + 0.5f) * vec2(settings.size)), 0.5f);
}

// H71: what lies under the water, or behind the mirror, is not seen in it, however close below.
TEST_F(WindowsTest, WhatLiesBehindTheMirrorIsNeverSeenInIt)
{
    const uint glass = addMaterial(scene, mirror());
    addQuad(scene, vec3(-9, 0, 9), vec3(18, 0, 0), vec3(0, 0, -18), glass);
    const uint hidden = lampOf(vec3(0, 9, 0));
    addQuad(scene, vec3(-8, -0.001f, 8), vec3(16, 0, 0), vec3(0, 0, -16), hidden);
    addQuad(scene, vec3(-2, -3, -2), vec3(4, 0, 0), vec3(0, 2.9f, 0), hidden);
    addQuad(scene, vec3(-1, -1, -4), vec3(2, 0, 0), vec3(0, 1.5f, 0), lampOf(vec3(1, 0, 0))); // through the surface: only its upper part
    const Camera camera = lookAt(vec3(0, 1, 1), vec3(0, 0, -3), 1.0f);
    const Image picture = draw(scene, camera);
    float red = 0.0f;
    for (int i = 0; i < picture.width * picture.height; ++i) {
        EXPECT_EQ(picture.pixels[std::size_t(i) * 4 + 1], 0.0f);
        red = std::max(red, picture.pixels[std::size_t(i) * 4]);
    }
    EXPECT_NEAR(red, 1.0f, kHalves);
    // What stands out of the water is 0.5 m high, and so is its image
    EXPECT_GT(at(picture, pixelOf(camera, vec3(0, -0.45f, -4))).x, 0.9f);
    EXPECT_EQ(at(picture, pixelOf(camera, vec3(0, -0.6f, -4))).x, 0.0f);
}

// H71: an eye on the plane, or under water, sees nothing mirrored; the picture is as without the effect.
TEST_F(WindowsTest, AnEyeOnThePlaneOrUnderWaterHasNoMirror)
{
    Material water = mirror();
    water.metallic = 0.0f;
    furnish(water);
    for (const float height : {0.0f, -1.0f}) {
        const Camera camera = lookAt(vec3(0, height, 2), vec3(0, height, -3), 0.9f);
        settings.effects = {};
        const Image with = draw(scene, camera);
        EXPECT_EQ(ran("planar.0.geometry"), 0u);
        settings.effects = parseOverrides("-planar");
        EXPECT_EQ(with.pixels, draw(scene, camera).pixels);
    }
}

// H71: two mirrors at a right angle. Each shows the room; in it the other one mirrors its probes, which are blue.
TEST_F(WindowsTest, AMirrorInAMirrorKeepsItsProbes)
{
    const uint glass = addMaterial(scene, mirror());
    addQuad(scene, vec3(-2, -2, -2), vec3(4, 0, 0), vec3(0, 4, 0), glass); // at z = -2
    addQuad(scene, vec3(-2, -2, 2), vec3(0, 0, -4), vec3(0, 4, 0), glass); // at x = -2
    addQuad(scene, vec3(2, -2, 2), vec3(-4, 0, 0), vec3(0, 4, 0), lampOf(vec3(1, 0, 0)));
    addQuad(scene, vec3(2, -2, -2), vec3(0, 0, 4), vec3(0, 4, 0), lampOf(vec3(0, 1, 0)));
    isBaked = true;
    baked = bakedEvenly(scene, vec3(0.0f));
    baked.reflections.push_back(evenReflection(vec3(-2), vec3(2), vec3(0, 0, 1)));
    settings.size = {64, 16};
    const Camera camera = lookAt(vec3(0.5f, 0, 0.5f), vec3(-2, 0, -2), 0.3f); // flat: no look leaves over the walls
    const Image picture = draw(scene, camera);
    EXPECT_EQ(ran("planar.0.geometry"), 1u);
    EXPECT_EQ(ran("planar.1.geometry"), 1u);
    std::set<int> colors;
    for (int i = 0; i < picture.width * picture.height; ++i) {
        const float* p = &picture.pixels[std::size_t(i) * 4];
        EXPECT_NEAR(p[0] + p[1] + p[2], 1.0f, 5e-3f) << "each pixel is one of the three";
        colors.insert(p[0] > 0.5f ? 0 : p[1] > 0.5f ? 1 : 2);
    }
    EXPECT_EQ(colors.size(), 3u);
    // To x = -2, z = -1.5 and on to z = -2 at x = -1.4: the other mirror
    EXPECT_GT(at(picture, pixelOf(camera, vec3(-2, 0, -1.5f))).z, 0.9f);
    // To x = -0.2, z = -2 and on to z = 2 at x = -1.3: the red wall
    EXPECT_GT(at(picture, pixelOf(camera, vec3(-0.2f, 0, -2))).x, 0.9f);
}

TEST_F(WindowsTest, CoplanarMirrorsShareOneEye)
{
    const uint glass = addMaterial(scene, mirror());
    for (const float x : {-2.0f, 0.0f, 2.0f}) addQuad(scene, vec3(x - 0.5f, -1, -3), vec3(1, 0, 0), vec3(0, 2, 0), glass);
    addQuad(scene, vec3(-9, -9, 3), vec3(0, 18, 0), vec3(18, 0, 0), lampOf(vec3(1, 2, 3)));
    const Camera camera = lookAt(vec3(0), vec3(0, 0, -3), 1.2f);
    const Image picture = draw(scene, camera);
    EXPECT_EQ(ran("planar.0.geometry"), 1u);
    EXPECT_EQ(ran("planar.1.geometry"), 0u);
    EXPECT_NE(need(needs(scene), "planar").reason.find("1 plane"), std::string::npos);
    for (const float x : {-2.0f, 0.0f, 2.0f}) EXPECT_NEAR(at(picture, pixelOf(camera, vec3(x, 0, -3))).z, 3.0f, 0.01f) << x;
}

// A mirror out of sight costs nothing; one far away costs its few pixels.
TEST_F(WindowsTest, AMirrorCostsThePixelsThatItMayCover)
{
    addQuad(scene, vec3(-0.5f, -0.5f, -10), vec3(1, 0, 0), vec3(0, 1, 0), addMaterial(scene, mirror()));
    settings.size = {640, 480};
    Stage stage = makeStage(gpu, scene, nullptr, settings);
    const auto views = [&](vec3 target) { return windowsOf(stage, makeView(lookAt(vec3(0), target), settings.size), settings).mirrors; };
    EXPECT_TRUE(views(vec3(0, 0, 1)).empty());
    ASSERT_EQ(views(vec3(0, 0, -1)).size(), 1u);
    const uvec2 size = views(vec3(0, 0, -1))[0].view.size; // 57 px wide, in steps of 32
    EXPECT_LE(size.x, 96u);
    EXPECT_LE(size.y, 96u);
    EXPECT_GE(size.x, 57u);
}
}
