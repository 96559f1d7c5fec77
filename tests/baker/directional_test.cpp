// Lightmaps that tell normals apart, against light whose irradiance about any normal is known on paper.
#include "baker/baker.hpp"
#include "rooms.hpp"
#include "shaders/lightmap.h"
#include "shaders/sampling.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace afterglow
{
static const vec3 kUp(0.0f, 1.0f, 0.0f);

static vec3 leaning(float degrees, float azimuth = 0.0f)
{
    const float lean = degrees * kPi / 180.0f;
    return vec3(std::sin(lean) * std::cos(azimuth), std::cos(lean), std::sin(lean) * std::sin(azimuth));
}

// A single light is told to the last bit that matters wherever it lights the whole ring of normals, and near it.
TEST(Directional, knowsASingleLight)
{
    for (float height : {0.0f, 20.0f, 45.0f}) {
        const vec3 light = leaning(height, 0.3f);
        const vec4 direction = directionAbout(directionOf(light, kUp), kUp);
        EXPECT_NEAR(directionShare(direction, kUp), 1.0f, 1e-6f);
        for (float lean : {5.0f, 25.0f, 60.0f, 85.0f})
            for (float azimuth : {0.3f, 1.5f, 3.5f}) {
                const vec3 n = leaning(lean, azimuth);
                EXPECT_NEAR(directionShare(direction, n), std::max(dot(light, n), 0.0f) / dot(light, kUp), 1e-5f) << height << " " << lean;
            }
    }
}

// Light from everywhere above: irradiance about a normal that leans by t is (1 + cos t) / 2 of that about none, at the ring's own 40
// degrees but for what kLeastCosine leaves out.
TEST(Directional, knowsAnOpenSky)
{
    constexpr int kDirections = 1 << 16;
    dvec3 sum(0.0);
    for (uint i = 0; i < kDirections; i++) {
        Sampler random = makeSampler(1u, i);
        const vec3 local = sampleCosineHemisphere(next2(random));
        sum += dvec3(directionOf(vec3(local.x, local.z, local.y), kUp));
    }
    const vec4 direction = directionAbout(vec3(sum / double(kDirections)), kUp);
    for (float azimuth : {0.0f, 2.0f, 4.0f})
        EXPECT_NEAR(directionShare(direction, leaning(40.0f, azimuth)), 0.5f * (1.0f + kLeanCosine), 5e-3f);
}

// Light that grazes, and comes from behind or from nowhere, is finite.
TEST(Directional, isFinite)
{
    for (vec3 light : {vec3(1, 0, 0), vec3(0, -1, 0), normalize(vec3(1.0f, 1e-7f, 0.0f)), normalize(vec3(-1.0f, -1e-20f, 1.0f)), kUp}) {
        const vec3 d = directionOf(light, kUp);
        EXPECT_LE(length(d), 65.0f) << light.x << " " << light.y;
    }
}

static Baked bakeOf(const Scene& scene, bool directional, Denoiser denoiser = Denoiser::none)
{
    BakeOptions options;
    options.texelsPerMetre = 4.0f;
    options.samples = 1024;
    options.directional = directional;
    options.directAll = true;
    options.probes = options.reflections = options.lods = options.voxels = false;
    options.denoiser = denoiser;
    Progress silent(ProgressStyle::none);
    nlohmann::json told;
    return bakeScene(scene, options, silent, told);
}

static float irradianceAt(const Baked& baked, vec3 position, vec3 normal)
{
    ProbePoint point;
    point.position = position;
    point.normal = normal;
    return probeBaked(baked, {point})[0].value[0].x / kPi;
}

// In the middle of the floor, between two texels of which one is as much too bright as the other is too dark.
static float inTheMiddle(const Baked& baked, vec3 normal)
{
    return 0.5f * (irradianceAt(baked, vec3(-0.125f, -1.0f, 0.1f), normal) + irradianceAt(baked, vec3(0.125f, -1.0f, 0.1f), normal));
}

// The floor of a room whose half x > 0 shines: light fills a quarter of the sphere. About a normal that leans by t towards it irradiance /
// pi is (cos t + sin t) / 2, and (1 - sin t) / 2 about one that leans away.
TEST(Directional, isNearTheTruthUnderHalfASky)
{
    const Baked baked = bakeOf(halfLitRoom(), /* directional= */ true);
    double flat = 0.0, bent = 0.0;
    int count = 0;
    for (float lean : {-45.0f, -30.0f, -15.0f, 15.0f, 30.0f, 45.0f}) {
        const float t = lean * kPi / 180.0f, truth = 0.5f * (lean > 0.0f ? std::cos(t) + std::sin(t) : 1.0f + std::sin(t));
        const float told = inTheMiddle(baked, leaning(lean));
        flat += std::pow(double(0.5f - truth) / 0.5, 2.0), bent += std::pow(double(told - truth) / 0.5, 2.0);
        count++;
        EXPECT_NEAR(told, truth, 0.06f * 0.5f) << lean;
    }
    std::printf("RMSE of the flat value, about normals that lean by up to 45 degrees: flat %.1f %%, directional %.1f %%\n",
                100.0 * std::sqrt(flat / count), 100.0 * std::sqrt(bent / count));
    EXPECT_NEAR(inTheMiddle(baked, kUp), 0.5f, 0.02f);
    EXPECT_GT(flat, 36.0 * bent);
}

// A point light is met by next-event estimation alone; it lights from one direction.
TEST(Directional, knowsWhereALampIs)
{
    Scene scene = furnace(0.0f);
    scene.materials[0].emission = vec3(0.0f);
    Light lamp{};
    lamp.type = kLightPoint;
    lamp.intensity = vec3(1.0f);
    lamp.position = vec3(0.3f, 0.5f, 0.2f);
    scene.lights.push_back(lamp);
    const Baked baked = bakeOf(scene, /* directional= */ true);
    const vec3 middle(0.0f, -1.0f, 0.0f), toLamp = normalize(lamp.position - middle);
    for (float azimuth : {0.0f, 1.6f, 3.1f}) {
        const vec3 n = leaning(30.0f, azimuth);
        EXPECT_NEAR(irradianceAt(baked, middle, n) / irradianceAt(baked, middle, kUp), dot(toLamp, n) / dot(toLamp, kUp), 0.02f);
    }
}

// Beside the direction nothing changes: the flat values are the same bits, and about the surface's own normal they are what is told.
TEST(Directional, leavesTheFlatLightmapAsItIs)
{
    const Baked flat = bakeOf(halfLitRoom(), /* directional= */ false), bent = bakeOf(halfLitRoom(), /* directional= */ true);
    ASSERT_EQ(flat.lightmaps.size(), bent.lightmaps.size());
    EXPECT_TRUE(flat.lightmaps[0].direction.empty());
    for (std::size_t p = 0; p < flat.lightmaps.size(); p++) EXPECT_EQ(flat.lightmaps[p].texels, bent.lightmaps[p].texels);
    for (float x : {-0.7f, -0.1f, 0.35f, 0.8f}) {
        const vec3 point(x, -1.0f, 0.2f);
        EXPECT_NEAR(irradianceAt(bent, point, kUp), irradianceAt(flat, point, kUp), 1e-5f) << x;
    }
}

// The filter and the dilation carry directions along: they keep the flat value about the surface's own normal, and near the truth.
TEST(Directional, isFilteredWithItsLight)
{
    const Baked baked = bakeOf(halfLitRoom(), /* directional= */ true, Denoiser::builtin);
    EXPECT_NEAR(inTheMiddle(baked, leaning(30.0f)), 0.683f, 0.03f);
    EXPECT_NEAR(inTheMiddle(baked, leaning(-30.0f)), 0.25f, 0.03f);
    for (const Lightmap& page : baked.lightmaps)
        for (std::size_t i = 0; i < page.texels.size(); i++) {
            if (page.valid[i] != 1) continue;
            // Six faces, each flat: a + d.N = 1 about one of six normals
            float nearest = 1.0f;
            for (int side = 0; side < 6; side++) {
                vec3 n(0.0f);
                n[side % 3] = side < 3 ? 1.0f : -1.0f;
                nearest = std::min(nearest, std::abs(page.direction[i].w + dot(vec3(page.direction[i]), n) - 1.0f));
            }
            EXPECT_LT(nearest, 1e-4f);
        }
}
}
