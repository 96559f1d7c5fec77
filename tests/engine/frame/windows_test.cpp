// Mirrors and portals in whole frames: what they show is held against a picture that needs none, pixel by pixel.
#include "engine/frame/windows.hpp"
#include "shaders/fresnel.h"
#include "tests/engine/gpu/validated.hpp"
#include "tests/engine/upload/toy_level.hpp"
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace afterglow
{
// Radiance is kept as half floats, 2^-11, twice.
constexpr float kHalves = 2e-3f;

class WindowsTest : public Validated
{
protected:
    Scene scene;
    Baked baked;
    bool isBaked = false;
    Settings settings;
    FrameStats stats;
    Image sum; // of the picture's layers, when they are asked for
    Executor executor{gpu};

    WindowsTest() { settings.size = {64, 48}; }

    Image draw(const Scene& level, const Camera& camera)
    {
        baked.scene = level;
        Stage stage = makeStage(gpu, level, isBaked ? &baked : nullptr, settings);
        Graph graph;
        const Pictures pictures = drawFrame(graph, stage, makeView(camera, settings.size), settings);
        const Layers& l = pictures.layers;
        graph.output(pictures.radiance);
        for (const Texture& layer : {l.direct, l.indirect, l.reflection, l.emission})
            if (layer) graph.output(layer);
        stats = executor.run(graph, stage.level->set);
        Image picture = executor.download(pictures.radiance);
        sum = Image(picture.width, picture.height, 4);
        for (const Texture& layer : {l.direct, l.indirect, l.reflection, l.emission}) {
            if (!layer) continue;
            const Image part = executor.download(layer);
            for (std::size_t i = 0; i < sum.pixels.size(); ++i) sum.pixels[i] += part.pixels[i];
        }
        return picture;
    }
    std::size_t ran(const std::string& pass) const
    {
        return std::size_t(std::count_if(stats.passes.begin(), stats.passes.end(), [&](const PassStats& p) { return p.name == pass; }));
    }

    // An ideal mirror: a metal of roughness 0 that reflects everything, at every angle.
    static Material mirror(float roughness = 0.0f)
    {
        Material m = matte(vec3(1.0f));
        m.flags = kMaterialMirror;
        m.metallic = 1.0f;
        m.roughness = roughness;
        return m;
    }
    static Material lamp(vec3 emission)
    {
        Material m = matte(vec3(0.0f));
        m.emission = emission;
        m.flags |= kMaterialDoubleSided;
        return m;
    }
    uint lampOf(vec3 emission) { return addMaterial(scene, lamp(emission)); }

    // Where the surfaces of that material are seen: the picture with everything black but them.
    std::vector<bool> seen(uint material, const Camera& camera)
    {
        Scene level = scene;
        for (Object& object : level.objects) object.portal.clear(), object.mirror = false;
        for (uint i = 0; i < level.materials.size(); ++i) level.materials[i] = lamp(vec3(i == material ? 1.0f : 0.0f));
        level.sky = {};
        const bool wasBaked = std::exchange(isBaked, false);
        const Image mask = draw(level, camera);
        isBaked = wasBaked;
        std::vector<bool> pixels;
        for (int i = 0; i < mask.width * mask.height; ++i) pixels.push_back(mask.pixels[std::size_t(i) * 4] > 0.5f);
        return pixels;
    }

    // Of the pixels of `mask`, how many differ.
    static int differing(const Image& a, const Image& b, const std::vector<bool>& mask)
    {
        int count = 0;
        for (std::size_t i = 0; i < mask.size(); ++i) {
            bool same = true;
            for (std::size_t c = 0; c < 3; ++c) {
                const float x = a.pixels[i * 4 + c], y = b.pixels[i * 4 + c];
                same &= std::abs(x - y) <= kHalves * std::max(std::abs(y), 1e-2f);
            }
            count += mask[i] && !same;
        }
        return count;
    }
    static vec3 at(const Image& image, ivec2 pixel)
    {
        const float* p = image.at(pixel.x, pixel.y);
        return vec3(p[0], p[1], p[2]);
    }
    ivec2 pixelOf(const Camera& camera, vec3 world) const
    {
        const vec4 clip = makeView(camera, settings.size).worldToClip * vec4(world, 1.0f);
        return ivec2((vec2(clip) / clip.w * 0.5f + 0.5f) * vec2(settings.size));
    }

    // A floor at y = 0, and above it lamps and a lit wall, none of them alike.
    uint furnish(const Material& floor)
    {
        const uint water = addMaterial(scene, floor);
        addQuad(scene, vec3(-9, 0, 9), vec3(18, 0, 0), vec3(0, 0, -18), water).mirror = true;
        addQuad(scene, vec3(-2, 0.31f, -4), vec3(1, 0.1f, 0), vec3(0, 1.1f, 0.2f), lampOf(vec3(3, 1, 0.5f)));
        addQuad(scene, vec3(0.4f, 0.13f, -5), vec3(1.3f, 0, -1), vec3(0.2f, 2, 0), lampOf(vec3(0.2f, 2, 1)));
        addQuad(scene, vec3(-3, 0.5f, -6), vec3(6, 0, 0), vec3(0, 4, 0), addMaterial(scene, matte(vec3(0.64f, 0.3f, 0.2f))));
        addLight(scene, pointLight(vec3(0.3f, 2.5f, -3), vec3(40.0f)));
        scene.sky.radiance = vec3(0.25f, 0.5f, 1.0f);
        return water;
    }
    // The same world under the floor, and no floor.
    Scene upsideDown() const
    {
        Scene level = scene;
        level.objects.erase(level.objects.begin());
        for (Vertex& v : level.vertices) v.position.y = -v.position.y, v.normal.y = -v.normal.y;
        for (std::size_t i = 0; i + 2 < level.indices.size(); i += 3) std::swap(level.indices[i + 1], level.indices[i + 2]);
        for (Light& light : level.lights) light.position.y = -light.position.y;
        return level;
    }
};

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

// A mirror on the wall, askew: the lamp straight before it is seen at its foot, halfway between the foots of eye and lamp by their distances.
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

// A normal map that tilts everything by one angle turns what is mirrored by twice that. The eye looks straight down from 2 m; a wall of lamp
// lies 4 m above the water (seen to x < a edge): its border is seen where the turned look meets it.
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

class Portals : public WindowsTest
{
protected:
    // Room A before a wall with a portal, room B 100 m away, whose portal is turned by a right angle; nothing in B is alike.
    Portals()
    {
        door = addMaterial(scene, matte(vec3(0.5f)));
        const auto twin = [&](const char* name, const char* other, const dmat4& toWorld) {
            Object& object = addQuad(scene, vec3(-1, -1.2f, 0), vec3(2, 0, 0), vec3(0, 2.4f, 0), door);
            object.name = name, object.portal = other, object.toWorld = toWorld;
        };
        a[3] = dvec4(0, 0, -3, 1);                                                                  // faces +z
        b = dmat4(dvec4(0, 0, 1, 0), dvec4(0, 1, 0, 0), dvec4(-1, 0, 0, 0), dvec4(100, 0.2, 0, 1)); // faces -x
        twin("A", "B", a);
        twin("B", "A", b);
        addQuad(scene, vec3(95, -3, -4), vec3(0, 0, 3.3f), vec3(0, 4, 0), lampOf(vec3(1, 0, 0)));
        addQuad(scene, vec3(96, -3, 0.4f), vec3(0, 0, 3.3f), vec3(0, 4, 0), lampOf(vec3(0, 1, 0)));
        addQuad(scene, vec3(96.5f, 0.4f, -1), vec3(0, 0, 1), vec3(0, 0.4f, 0), lampOf(vec3(0, 0, 1)));
        scene.sky.radiance = vec3(0.2f, 0.3f, 0.4f);
    }
    // Half a turn about y, from A's place to B's.
    mat4 there() const
    {
        dmat4 half(1.0);
        half[0][0] = half[2][2] = -1.0;
        return mat4(b * half * inverse(a));
    }
    uint door;
    dmat4 a{1.0}, b{1.0};
};

TEST_F(Portals, ShowWhatTheEyeWouldSeeOnTheOtherSide)
{
    const Camera camera = lookAt(vec3(0.3f, 0.1f, 1), vec3(0, 0, -3), 0.9f);
    const std::vector<bool> mask = seen(door, camera);
    const Image picture = draw(scene, camera);
    EXPECT_EQ(ran("portal.0.geometry"), 1u);
    EXPECT_EQ(ran("portal.1.geometry"), 0u); // out of sight

    Camera moved = camera;
    moved.toWorld = there() * camera.toWorld;
    Scene open = scene;
    open.objects.erase(open.objects.begin(), open.objects.begin() + 2);
    const Image beyond = draw(open, moved);
    EXPECT_EQ(differing(picture, beyond, mask), 0);
    std::set<std::pair<float, float>> colors;
    for (std::size_t i = 0; i < mask.size(); ++i)
        if (mask[i]) colors.insert({picture.pixels[i * 4], picture.pixels[i * 4 + 1]});
    EXPECT_GE(colors.size(), 4u) << "three lamps and the sky";
}

// What a mirror and a portal put into the picture is in its layers, too.
TEST_F(Portals, AndMirrorsKeepTheLayersInStep)
{
    addQuad(scene, vec3(-2, -1.2f, 3), vec3(4, 0, 0), vec3(0, 0, -6), addMaterial(scene, mirror()));
    addLight(scene, pointLight(vec3(0, 2, 0), vec3(9.0f)));
    Material pane = matte(vec3(0.5f));
    pane.baseColor.w = 0.25f;
    pane.flags |= kMaterialAlphaBlend;
    addQuad(scene, vec3(0, -1.2f, -1), vec3(2, 0, 0), vec3(0, 2.4f, 0), addMaterial(scene, pane)); // before one half of both
    settings.layers = true;
    const Image picture = draw(scene, lookAt(vec3(0.3f, 0.1f, 1), vec3(0, -0.3f, -3), 0.9f));
    EXPECT_EQ(ran("portal.0"), 1u);
    EXPECT_EQ(ran("planar.0"), 1u);
    EXPECT_EQ(differing(sum, picture, std::vector<bool>(64 * 48, true)), 0);
}

TEST_F(Portals, AreDimmedByAClearSurfaceBeforeThem)
{
    const Camera camera = lookAt(vec3(0.3f, 0.1f, 1), vec3(0, 0, -3), 0.9f);
    const std::vector<bool> mask = seen(door, camera);
    Image without = draw(scene, camera);
    for (float& value : without.pixels) value *= 0.75f;
    Material pane = matte(vec3(0.0f));
    pane.baseColor.w = 0.25f;
    pane.flags |= kMaterialAlphaBlend;
    addQuad(scene, vec3(-9, -9, -1), vec3(18, 0, 0), vec3(0, 18, 0), addMaterial(scene, pane));
    EXPECT_EQ(differing(draw(scene, camera), without, mask), 0);
}

// Mirrors and portals share what a frame may draw.
TEST_F(Portals, AndMirrorsHaveOneBound)
{
    addQuad(scene, vec3(-2, -1.2f, 3), vec3(4, 0, 0), vec3(0, 0, -6), addMaterial(scene, mirror()));
    Stage stage = makeStage(gpu, scene, nullptr, settings);
    Windows windows = windowsOf(stage, makeView(lookAt(vec3(0.3f, 0.1f, 1), vec3(0, -0.3f, -3), 0.9f), settings.size), settings);
    EXPECT_EQ(windows.left, 64u);
    windows.left = 1;
    Graph graph;
    EXPECT_EQ(lookThrough(graph, stage, windows.mirrors, {}, settings, windows.left).size(), 1u);
    EXPECT_EQ(lookThrough(graph, stage, windows.portals, {}, settings, windows.left).size(), 0u);
}

TEST_F(Portals, AreTheirOwnSurfaceFromBehindAndWhenTurnedOff)
{
    const Camera behind = lookAt(vec3(0, 0, -5), vec3(0, 0, -3));
    draw(scene, behind);
    EXPECT_EQ(ran("portal.0.geometry"), 0u);
    settings.portal.depth = 0;
    draw(scene, lookAt(vec3(0), vec3(0, 0, -3)));
    EXPECT_EQ(ran("portal.0.geometry"), 0u);
}

// Two portals that face each other, as deep as one asks: each look ends.
TEST_F(Portals, ThatFaceEachOtherEndAtTheirDepth)
{
    scene.objects[1].toWorld = dmat4(dvec4(-1, 0, 0, 0), dvec4(0, 1, 0, 0), dvec4(0, 0, -1, 0), dvec4(0, 0, 3, 1)); // faces -z, at z = 3
    const Camera camera = lookAt(vec3(0.1f, 0.2f, 2), vec3(0, 0, -3), 0.9f);
    for (const uint depth : {1u, 3u, kDeepestPortal}) {
        settings.portal.depth = depth;
        const Image picture = draw(scene, camera);
        std::size_t frames = 0;
        for (const PassStats& p : stats.passes) frames += p.name.ends_with("geometry") ? 1 : 0;
        EXPECT_EQ(frames, 1u + depth);
        for (const float value : picture.pixels) ASSERT_TRUE(std::isfinite(value));
    }
}

TEST_F(Portals, WithoutATwinAreCalledByName)
{
    scene.objects[0].portal = "C";
    scene.objects[1].portal.clear();
    EXPECT_FALSE(need(needs(scene), "portal").on);
    EXPECT_EQ(need(needs(scene), "portal").reason, "node \"A\": no mesh node is called \"C\"");
}
}
