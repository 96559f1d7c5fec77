// Paths that end where light is known, against paths that are traced to their end.
#include "baker/baker.hpp"
#include "baker/light_cache.hpp"
#include "baker/tile_light.hpp"
#include "rooms.hpp"
#include "shaders/lightmap.h"
#include "shaders/probe.h"
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace afterglow
{
namespace
{
// The mean of all texels, and what a texel is off by, relative.
struct Result {
    double mean = 0.0, error = 0.0;
};

Result bakeAll(const Scene& scene, bool cache, int samples)
{
    BakeOptions options;
    options.texelsPerMetre = 4.0f;
    options.samples = samples;
    options.denoiser = Denoiser::none;
    options.stitch = false;
    options.lightCache = cache;
    options.probes = options.reflections = options.lods = options.voxels = false;
    Progress silent(ProgressStyle::none);
    nlohmann::json told;
    const Baked baked = bakeScene(scene, options, silent, told);
    Result result{0.0, told["products"]["lightmaps"]["estimated_error"]};
    double texels = 0.0;
    for (const Lightmap& page : baked.lightmaps)
        for (std::size_t i = 0; i < page.texels.size(); i++)
            if (page.valid[i] == 1) result.mean += double(luminance(page.texels[i])), texels += 1.0;
    result.mean /= texels;
    return result;
}

// A lacquered floor under a black ceiling, and a sun whose direct light the lightmap does not hold: all that is in it comes off the floor.
Scene floorInTheSun(vec3 towardsSun)
{
    Scene scene;
    Material floor = shining(0.0f, 0.8f);
    floor.flags = 0;
    floor.roughness = 0.5f, floor.ior = 1.5f, floor.specular = 1.0f, floor.specularColor = vec3(1.0f);
    addSurface(scene, moved(box(vec3(4.0f, 0.5f, 4.0f)), vec3(0.0f, -0.25f, 0.0f)), floor);
    addSurface(scene, moved(box(vec3(1.0f, 0.25f, 1.0f)), vec3(0.0f, 1.125f, 0.0f)), shining(0.0f));
    Light sun{};
    sun.type = kLightDirectional;
    sun.direction = -normalize(towardsSun);
    sun.intensity = vec3(2.0f);
    scene.lights = {sun};
    scene.lower = vec3(-2.0f, -0.5f, -2.0f), scene.upper = vec3(2.0f, 1.25f, 2.0f);
    return scene;
}
}

// A layer lets in more of what comes from above than of what grazes: the mean over the hemisphere would be 4 % too dark for one sun, and as much too
// bright for the other.
TEST(LightCache, HoldsWhatTheLayerOfASurfaceLetsIn)
{
    for (const vec3 sun : {vec3(1.0f, 1.2f, 0.3f), vec3(1.0f, 0.2f, 0.1f)}) {
        const Scene scene = floorInTheSun(sun);
        const Result paths = bakeAll(scene, false, 2048), cached = bakeAll(scene, true, 2048);
        EXPECT_NEAR(cached.mean / paths.mean, 1.0, 0.012) << sun.y;
    }
}

// In a box whose light goes on for many bounces, nothing is lost.
TEST(LightCache, HoldsAllBounces)
{
    Scene scene;
    addSurface(scene, flipped(box(vec3(2.0f))), shining(0.1f, 0.8f));
    scene.lower = vec3(-1.0f), scene.upper = vec3(1.0f);
    const Result cached = bakeAll(scene, true, 128);
    EXPECT_NEAR(cached.mean, 0.1 / (1.0 - 0.8), 0.5 * 0.01); // radiance everywhere: what shines, and what comes back of it
    EXPECT_LT(cached.error, 0.03);
}

// Where no lightmap is made its paths are traced for the probes; nobody gets the charts.
TEST(LightCache, IsFilledForProbesAlone)
{
    Scene scene;
    addSurface(scene, flipped(icosphere(3)), shining(0.1f, 0.8f)); // its charts part vertices
    scene.lower = vec3(-1.0f), scene.upper = vec3(1.0f);
    BakeOptions options;
    options.lightmaps = options.reflections = options.lods = options.voxels = false;
    options.texelsPerMetre = 16.0f;
    options.probeError = 0.0f;
    double cost[2]; // rays that an error of 1 would take
    for (const bool cache : {false, true}) {
        options.lightCache = cache;
        Progress silent(ProgressStyle::none);
        nlohmann::json told;
        const Baked baked = bakeScene(scene, options, silent, told);
        const double error = told["products"]["probes"]["estimated_error"];
        cost[cache] = double(told["products"]["probes"]["rays"]) * error * error;
        double mean = 0.0; // radiance is 0.1 / (1 - 0.8) everywhere
        for (const Probe& probe : baked.probes.probes) mean += double(probeIrradiance(probe, vec3(0.0f, 1.0f, 0.0f)).x);
        EXPECT_NEAR(mean / double(baked.probes.probes.size()), 0.5, 0.5 * 0.02); // probes share the noise of their cache
        EXPECT_EQ(told["products"]["probes"].contains("learned"), cache);
        EXPECT_EQ(baked.scene.vertices.size(), scene.vertices.size());
        EXPECT_EQ(baked.scene.indices, scene.indices);
        EXPECT_EQ(baked.places[0].page, -1);
        EXPECT_TRUE(baked.lightmaps.empty());
    }
    EXPECT_LT(cost[1], 0.5 * cost[0]);
}

// Objects that ask for many texels get no more of them than what is worth it.
TEST(LightCache, OfProbesAloneIsAsFineAsTheyAsk)
{
    BakeOptions options;
    options.probeError = 0.2f;
    options.lightmaps = options.reflections = options.lods = options.voxels = false;
    double rays[2];
    for (const bool fine : {false, true}) {
        Scene scene = loadLevel("content/cornell/cornell.glb");
        for (Object& object : scene.objects) object.texelsPerMetre = fine ? 300.0f : 0.0f;
        Progress silent(ProgressStyle::none);
        nlohmann::json told;
        bakeScene(scene, options, silent, told);
        EXPECT_TRUE(told["products"]["probes"].contains("learned"));
        rays[fine] = told["products"]["probes"]["rays"];
    }
    EXPECT_NEAR(rays[1] / rays[0], 1.0, 0.1);
}

TEST(LightCache, KnowsWhatItWasToldAndNothingNear)
{
    Scene scene;
    addSurface(scene, moved(box(vec3(1.0f)), vec3(0.0f)), shining(0.0f, 0.5f));
    for (Vertex& vertex : scene.vertices) vertex.uv1 = vec2(vertex.position.x, vertex.position.z) + 0.5f;
    scene.lower = vec3(-0.5f), scene.upper = vec3(0.5f);
    const World world(scene, Content::staticOnly);
    const std::vector<LightmapPlace> places = {{0, vec2(1.0f), vec2(0.0f)}};
    LightCache cache(places, {ivec2(8)}, false);
    TexelLight told;
    for (int half = 0; half < 2; half++) told.half[half] = dvec3(4.0 + 2.0 * half), told.count[half] = told.told[half] = 2;
    told.more[1] = vec3(-1.0f), told.points = 1;
    cache.keep(0, ivec2(6, 1), told);

    const auto asked = [&](vec3 origin, int half) {
        const Hit hit = world.closestHit(Ray{origin, vec3(0.0f, -1.0f, 0.0f), kRayFar});
        vec3 light(-1.0f);
        return hit.distance < kRayFar && cache.find(world, hit, vec3(0.0f, 1.0f, 0.0f), half, light) ? double(light.x) : -1.0;
    };
    const vec3 over(6.5f / 8.0f - 0.5f, 2.0f, 1.5f / 8.0f - 0.5f);
    EXPECT_EQ(asked(over, 0), 2.0);
    EXPECT_EQ(asked(over, 1), 2.5);
    EXPECT_EQ(asked(over + vec3(0.125f, 0.0f, 0.0f), 0), -1.0) << "of which nothing was told";
    EXPECT_EQ(asked(vec3(over.x, 0.5f + 0.2f, over.z), 0), 2.0);
    EXPECT_EQ(asked(vec3(over.x, 0.5f + 0.1f, over.z), 0), -1.0) << "within a texel";
}

namespace
{
// A floor of 8 by 8 m, one texel a metre, its corner in the origin.
Scene tiledFloor(const Material& material)
{
    Scene scene;
    add(scene, plate(vec3(4.0f, 0.0f, 4.0f), 4.0f), material);
    for (Vertex& vertex : scene.vertices) vertex.uv1 = vec2(vertex.position.x, vertex.position.z) / 8.0f;
    scene.lower = vec3(0.0f), scene.upper = vec3(8.0f, 4.0f, 8.0f);
    return scene;
}

// A texel that a path of each half has told of.
TexelLight lightOf(float each, vec3 position)
{
    TexelLight light;
    for (int half = 0; half < 2; half++) light.half[half] = dvec3(each), light.count[half] = light.told[half] = 1;
    light.position = dvec3(position), light.normal = dvec3(0.0, 1.0, 0.0), light.points = 1;
    return light;
}
}

// Light that leans by 30 degrees falls on a normal that leans towards it by 20 as by 10; each half says what it has found, here from both sides.
TEST(LightCache, TellsTheLightOfABentNormal)
{
    Material bent = matte(0.5f);
    bent.normalTexture.texture = 0;
    const Scene scene = tiledFloor(bent);
    const World world(scene, Content::staticOnly);
    const std::vector<LightmapPlace> places = {{0, vec2(1.0f), vec2(0.0f)}};
    LightCache flat(places, {ivec2(8)}, false), directional(places, {ivec2(8)}, true);
    const vec3 up(0.0f, 1.0f, 0.0f);
    const auto leaning = [](float degrees) { return vec3(std::sin(radians(degrees)), std::cos(radians(degrees)), 0.0f); };
    TexelLight light = lightOf(2.0f, vec3(2.5f, 0.0f, 2.5f));
    for (int half = 0; half < 2; half++) light.turn[half] = 2.0f * directionOf(leaning(half == 0 ? 30.0f : -30.0f), up);
    for (LightCache* cache : {&flat, &directional}) cache->keep(0, ivec2(2), light);

    const Hit hit = world.closestHit(Ray{vec3(2.5f, 3.0f, 2.5f), -up, kRayFar});
    vec3 found;
    EXPECT_FALSE(flat.find(world, hit, leaning(20.0f), 0, found));
    for (int half = 0; half < 2; half++) {
        ASSERT_TRUE(directional.find(world, hit, leaning(20.0f), half, found));
        const double truth = 2.0 * std::cos(radians(half == 0 ? 10.0 : 50.0)) / std::cos(radians(30.0));
        EXPECT_NEAR(double(found.x), truth, 0.05 * truth);
        ASSERT_TRUE(directional.find(world, hit, up, half, found));
        EXPECT_NEAR(double(found.x), 2.0, 1e-6);
    }
}

// Of three texels in a row, whose light falls by each of two edges.
TEST(LightCache, ForgetsWhatAWallPartsAndNotWhatAShadowDoes)
{
    const Scene scene = tiledFloor(matte(0.5f));
    const World world(scene, Content::staticOnly);
    const std::vector<LightmapPlace> places = {{0, vec2(1.0f), vec2(0.0f)}};
    const auto known = [&](float darker, float wall) { // at x; m
        LightCache cache(places, {ivec2(8)}, false);
        for (int x = 2; x < 5; x++) cache.keep(0, ivec2(x, 4), lightOf(x < 4 ? 1.0f : darker, vec3(float(x) + 0.5f, 0.0f, 4.5f)));
        cache.settle([&](vec3 from, vec3 to, vec3) { return (from.x < wall) == (to.x < wall); }, 1);
        std::string told;
        for (int x = 2; x < 5; x++) {
            const Hit hit = world.closestHit(Ray{vec3(float(x) + 0.5f, 3.0f, 4.5f), vec3(0.0f, -1.0f, 0.0f), kRayFar});
            vec3 light;
            told += cache.find(world, hit, vec3(0.0f, 1.0f, 0.0f), 0, light) ? '+' : '-';
        }
        return told;
    };
    EXPECT_EQ(known(0.2f, 9.0f), "+++") << "a shadow";
    EXPECT_EQ(known(0.2f, 4.0f), "+--") << "a wall between the two that differ";
    EXPECT_EQ(known(0.2f, 3.0f), "+-+") << "a wall behind one whose light may come from beyond it";
    EXPECT_EQ(known(0.3f, 4.0f), "+++") << "as bright on both sides";
}

// Of 64 texels four are a hundred times as bright: in one half of their paths alone, which is chance, or in both.
TEST(LightCache, ForgetsWhatOnePathInManyHasFound)
{
    const Scene scene = tiledFloor(matte(0.5f));
    const World world(scene, Content::staticOnly);
    const std::vector<LightmapPlace> places = {{0, vec2(1.0f), vec2(0.0f)}};
    for (const bool both : {false, true}) {
        LightCache cache(places, {ivec2(8)}, false);
        const auto isBright = [](int x, int y) { return x / 2 == 1 && y / 2 == 2; };
        for (int y = 0; y < 8; y++)
            for (int x = 0; x < 8; x++) {
                TexelLight light = lightOf(1.0f, vec3(float(x) + 0.5f, 0.0f, float(y) + 0.5f));
                if (isBright(x, y)) light.half[0] *= 100.0;
                if (isBright(x, y) && both) light.half[1] *= 100.0;
                cache.keep(0, ivec2(x, y), light);
            }
        cache.settle([](vec3, vec3, vec3) { return true; }, 1);
        for (int y = 0; y < 8; y++)
            for (int x = 0; x < 8; x++) {
                const Hit hit = world.closestHit(Ray{vec3(float(x) + 0.5f, 3.0f, float(y) + 0.5f), vec3(0.0f, -1.0f, 0.0f), kRayFar});
                vec3 light;
                EXPECT_EQ(cache.find(world, hit, vec3(0.0f, 1.0f, 0.0f), 1, light), both || !isBright(x, y)) << x << ' ' << y;
            }
    }
}

TEST(LightCache, IsNotToldByATexelOnBothSidesOfAWall)
{
    Scene scene = tiledFloor(matte(0.5f));
    const uint mesh = addMesh(scene, moved(box(vec3(0.01f, 4.0f, 8.0f)), vec3(3.6f, 2.0f, 4.0f)));
    scene.meshes[mesh].primitives[0].material = 0;
    addObject(scene, mesh);
    const World world(scene, Content::staticOnly);
    const std::vector<LightmapPlace> places = {{0, vec2(1.0f), vec2(0.0f)}, {-1, vec2(0.0f), vec2(0.0f)}};
    const TilePoints points = rasteriseTile(world, places, ivec2(8), binTriangles(world, places, {ivec2(8)})[0], ivec2(0));
    const std::bitset<kTileTexels> parted = partedTexels(world, points);
    for (std::size_t i = 0; i < points.size(); i++) EXPECT_EQ(parted[i], i % 8 == 3) << i;
}
}
