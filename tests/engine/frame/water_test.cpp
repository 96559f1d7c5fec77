// What a mirror adds to what it shows: Fresnel, ripples, the air and the clear surfaces before it.
#include "shaders/fresnel.h"
#include "tests/engine/frame/windows.hpp"

namespace afterglow
{
// Still water: what Fresnel says at the angle, of a sky that is the same everywhere, and the matte ground below gets the rest.
TEST_F(WindowsTest, StillWaterMirrorsByFresnel)
{
    Material water = mirror();
    water.metallic = 0.0f;
    water.baseColor = vec4(vec3(0.0f), 1.0f);
    water.ior = 1.33f;
    addQuad(scene, vec3(-99, 0, 99), vec3(198, 0, 0), vec3(0, 0, -198), addMaterial(scene, water)).mirror = true;
    scene.sky.radiance = vec3(2.0f);
    for (const float height : {0.3f, 1.0f, 5.0f}) {
        const Camera camera = lookAt(vec3(0, height, 0), vec3(0, 0, -2), 0.02f);
        const Image picture = draw(scene, camera);
        const float cosine = height / std::sqrt(height * height + 4.0f);
        const float wanted = 2.0f * fresnelDielectric(cosine, 1.33f);
        EXPECT_NEAR(at(picture, {32, 24}).x, wanted, 0.01f * wanted) << height;
    }
}

// Water that light passes, in still air: what it mirrors and what it lets through are all of the light, for one sky is above and below.
TEST_F(WindowsTest, ClearWaterMirrorsByFresnel)
{
    Material water = mirror();
    water.metallic = 0.0f;
    water.ior = 1.33f;
    water.transmission = 1.0f;
    addQuad(scene, vec3(-99, 0, 99), vec3(198, 0, 0), vec3(0, 0, -198), addMaterial(scene, water)).mirror = true;
    scene.sky.radiance = vec3(2.0f);
    const Image picture = draw(scene, lookAt(vec3(0, 0.3f, 0), vec3(0, 0, -2), 0.02f)); // Fresnel: 0.4
    EXPECT_EQ(ran("planar.0.clear"), 1u);
    EXPECT_EQ(ran("planar.0"), 0u);
    EXPECT_NEAR(at(picture, {32, 24}).x, 2.0f, 0.02f);
}

// A pane that lets 3/4 through: the way to the mirror and the way back lead through it.
TEST_F(WindowsTest, AClearSurfaceBeforeAMirrorDimsItsImage)
{
    addQuad(scene, vec3(-9, -9, -3), vec3(18, 0, 0), vec3(0, 18, 0), addMaterial(scene, mirror()));
    addQuad(scene, vec3(9, -9, 2), vec3(-18, 0, 0), vec3(0, 18, 0), lampOf(vec3(4.0f)));
    Material pane = matte(vec3(0.0f));
    pane.baseColor.w = 0.25f;
    pane.flags |= kMaterialAlphaBlend;
    addQuad(scene, vec3(-9, -9, -1), vec3(18, 0, 0), vec3(0, 18, 0), addMaterial(scene, pane));
    EXPECT_NEAR(at(draw(scene, lookAt(vec3(0), vec3(0, 0, -1), 0.02f)), {32, 24}).x, 4.0f * 0.75f * 0.75f, 0.01f);
}

// An eye behind a mirror has no memory of its air: no image is kept for it. Its march moves on with the frames that are gathered.
TEST_F(WindowsTest, FogInAMirrorKeepsNothingAndMovesOn)
{
    addQuad(scene, vec3(-9, -9, -3), vec3(18, 0, 0), vec3(0, 18, 0), addMaterial(scene, mirror()));
    addLight(scene, pointLight(vec3(0.3f, 0.2f, -1), vec3(9.0f)));
    Medium air{};
    air.scattering = vec3(0.1f);
    air.lower = vec3(-5), air.upper = vec3(5);
    scene.media.push_back(air);
    settings.fog.steps = 1;
    settings.effects = parseOverrides("-shadow");
    Stage stage = makeStage(gpu, scene, nullptr, settings);
    const Camera camera = lookAt(vec3(0), vec3(0, 0, -1), 0.5f);
    std::vector<std::vector<float>> seen;
    for (const uint number : {0u, 1u}) {
        View view = makeView(camera, settings.size);
        view.frame = number;
        forget(stage); // the fog before the mirror begins anew: what differs is in the mirror
        Graph graph;
        const Texture radiance = drawFrame(graph, stage, view, settings).radiance;
        graph.output(radiance);
        for (const Resource& resource : graph.resources)
            if (resource.name.starts_with("planar.")) {
                EXPECT_NE(resource.origin, Origin::historyCurrent) << resource.name;
            }
        executor.run(graph, stage.level->set);
        seen.push_back(executor.download(radiance).pixels);
    }
    EXPECT_NE(seen[0], seen[1]);
}

// A normal map that tilts everything by one angle turns what is mirrored by twice that. The eye looks straight down from 2 m; a wall of
// lamp lies 4 m above the water (seen to x < a edge): its border is seen where the turned look meets it.
TEST_F(WindowsTest, ATiltedNormalTurnsTheLookByTwiceItsAngle)
{
    const float tilt = 0.1f;
    Material water = mirror();
    water.normalTexture.texture = 0;
    const auto unorm = [](float x) { return std::uint8_t(std::lround((0.5f + 0.5f * x) * 255.0f)); };
    SceneTexture map;
    map.name = "tilt";
    map.image = Image8{1, 1, 4, {unorm(std::sin(tilt)), unorm(0.0f), unorm(std::cos(tilt)), 255}};
    scene.textures.push_back(map);
    addQuad(scene, vec3(-9, 0, 9), vec3(18, 0, 0), vec3(0, 0, -18), addMaterial(scene, water)).mirror = true; // u is +x
    addQuad(scene, vec3(0.8f, 4, -9), vec3(9, 0, 0), vec3(0, 0, 18), lampOf(vec3(1.0f)));                     // x from 0.8 on
    settings.size = {127, 31};
    const Camera camera = lookAt(vec3(0, 2, 0), vec3(0), 0.4f);
    const Image picture = draw(scene, camera);
    int edge = 0;
    while (edge < 127 && !(picture.at(edge, 15)[0] > 0.5f)) ++edge;
    // At x the look comes in from atan(x / 2) on the other side, leaves at that and twice the tilt, and rises 4 m
    const float x = ((float(edge) / 127.0f) * 2.0f - 1.0f) * std::tan(0.2f) * 127.0f / 31.0f * 2.0f;
    const float map_ = std::atan2((float(unorm(std::sin(tilt))) - 127.5f), (float(unorm(std::cos(tilt))) - 127.5f)); // as stored
    const float arrives = x + 4.0f * std::tan(std::atan(x / 2.0f) + 2.0f * map_);
    EXPECT_NEAR(arrives, 0.8f, 0.12f); // a pixel is 0.026 m on the water, three times that on the lamp; 8 bits of normal
    EXPECT_LT(edge, 127);
}

// Air that absorbs: the whole way counts, from the eye to the mirror and from there to the lamp.
TEST_F(WindowsTest, FogLiesBeforeTheMirrorAndInIt)
{
    addQuad(scene, vec3(-9, -9, -3), vec3(18, 0, 0), vec3(0, 18, 0), addMaterial(scene, mirror()));
    addQuad(scene, vec3(9, -9, 2), vec3(-18, 0, 0), vec3(0, 18, 0), lampOf(vec3(4.0f)));
    Medium air{};
    air.absorption = vec3(0.1f, 0.2f, 0.0f);
    air.lower = vec3(-99), air.upper = vec3(99);
    scene.media.push_back(air);
    const Camera camera = lookAt(vec3(0), vec3(0, 0, -1), 0.02f);
    const vec3 wanted = 4.0f * exp(-(3.0f + 5.0f) * air.absorption), got = at(draw(scene, camera), {32, 24});
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], wanted[c], 5e-3f * wanted[c]);
    EXPECT_EQ(ran("planar.0.fog"), 1u);
}
}
