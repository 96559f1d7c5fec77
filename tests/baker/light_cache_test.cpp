// Paths that end where light is known, against paths that are traced to their end.
#include "baker/baker.hpp"
#include "baker/light_cache.hpp"
#include "baker/tile_light.hpp"
#include "rooms.hpp"
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

TEST(LightCache, KnowsWhatItWasToldAndNothingNear)
{
    Scene scene;
    addSurface(scene, moved(box(vec3(1.0f)), vec3(0.0f)), shining(0.0f, 0.5f));
    for (Vertex& vertex : scene.vertices) vertex.uv1 = vec2(vertex.position.x, vertex.position.z) + 0.5f;
    scene.lower = vec3(-0.5f), scene.upper = vec3(0.5f);
    const World world(scene, Content::staticOnly);
    const std::vector<LightmapPlace> places = {{0, vec2(1.0f), vec2(0.0f)}};
    LightCache cache(places, {ivec2(8)});
    TexelLight told;
    for (int half = 0; half < 2; half++) told.half[half] = dvec3(4.0 + 2.0 * half), told.count[half] = told.told[half] = 2;
    told.more[1] = vec3(-1.0f);
    cache.keep(0, ivec2(6, 1), told);

    const auto asked = [&](vec3 origin, int half) {
        const Hit hit = world.closestHit(Ray{origin, vec3(0.0f, -1.0f, 0.0f), kRayFar});
        vec3 light(-1.0f);
        return hit.distance < kRayFar && cache.find(world, hit, half, light) ? double(light.x) : -1.0;
    };
    const vec3 over(6.5f / 8.0f - 0.5f, 2.0f, 1.5f / 8.0f - 0.5f);
    EXPECT_EQ(asked(over, 0), 2.0);
    EXPECT_EQ(asked(over, 1), 2.5);
    EXPECT_EQ(asked(over + vec3(0.125f, 0.0f, 0.0f), 0), -1.0) << "of which nothing was told";
    EXPECT_EQ(asked(vec3(over.x, 0.5f + 0.2f, over.z), 0), 2.0);
    EXPECT_EQ(asked(vec3(over.x, 0.5f + 0.1f, over.z), 0), -1.0) << "within a texel";
}
}
