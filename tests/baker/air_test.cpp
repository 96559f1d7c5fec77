// Air in the path tracer, order by order: what it scatters once against closed forms, what it sends out by itself, what it fills.
#include "baker/baker.hpp"
#include "shaders/medium.h"
#include "shaders/phase.h"
#include "shapes.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
// The mean of a small picture from `eye` along `direction`, with its standard error.
static dvec2 looking(const Scene& scene, vec3 eye, vec3 direction, std::optional<int> scatterings, int samples = 256)
{
    const vec3 side = normalize(std::abs(direction.y) > 0.9f ? vec3(1, 0, 0) : cross(direction, vec3(0, 1, 0)));
    TruthOptions options;
    options.camera.toWorld = mat4(vec4(side, 0), vec4(cross(side, direction), 0), vec4(-direction, 0), vec4(eye, 1));
    options.camera.fovY = 1e-3f;
    options.size = ivec2(16, 16);
    options.samples = samples;
    options.scatterings = scatterings;
    Progress silent(ProgressStyle::none);
    const Image image = truth(scene, options, silent);
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < 256; i++) {
        const double pixel = double(image.pixels[std::size_t(i) * 3]);
        sum += pixel;
        squares += pixel * pixel;
    }
    const double mean = sum / 256.0;
    return dvec2(mean, std::sqrt(std::max(squares / 256.0 - mean * mean, 0.0) / 255.0));
}

static void expectMet(dvec2 found, double wanted, double rounding = 1e-4)
{
    EXPECT_NEAR(found.x, wanted, 4.0 * found.y + rounding * std::abs(wanted)) << "standard error " << found.y;
}

static Medium air(float scattering, float absorption, float g, vec3 lower, vec3 upper)
{
    Medium medium{};
    medium.scattering = vec3(scattering), medium.absorption = vec3(absorption), medium.g = g;
    medium.lower = lower, medium.upper = upper;
    return medium;
}

// Chandrasekhar's slab under a sun; all orders send back more than the first.
TEST(Air, ofASlabScattersOnceByTheClosedForm)
{
    Scene scene;
    scene.media = {air(0.9f, 0.1f, 0.0f, vec3(-1e4f, -1, -1e4f), vec3(1e4f, 0, 1e4f))};
    Light sun{};
    sun.type = kLightDirectional;
    sun.direction = vec3(0.6f, -0.8f, 0.0f);
    sun.intensity = vec3(kPi);
    scene.lights = {sun};
    const vec3 down(0, -0.5f, -std::sqrt(0.75f)), up(0, 0.5f, down.z);
    const dvec2 back = looking(scene, vec3(0, 2, 0), down, 1);
    expectMet(back, 0.133092802);
    expectMet(looking(scene, vec3(0, -3, 0), up, 1), 0.09070170817);
    const dvec2 all = looking(scene, vec3(0, 2, 0), down, {});
    EXPECT_GT(all.x, back.x + 4.0 * (all.y + back.y));
    EXPECT_EQ(looking(scene, vec3(0, 2, 0), down, 0).x, 0.0);
}

// The airlight integral of a lamp; to the first order the lamp's light is dimmed both ways.
TEST(Air, aboutALampScattersOnceByTheAirlightIntegral)
{
    struct Row {
        float scattering, absorption, g;
        double value;
    };
    for (const Row& row : {Row{0.08f, 0.02f, 0.0f, 0.003666306671}, Row{0.08f, 0.02f, 0.7f, 0.003444902777}}) {
        Scene scene;
        scene.media = {air(row.scattering, row.absorption, row.g, vec3(-99), vec3(99, 99, 99))};
        scene.media[0].lower.z = -20; // the ray's 20 m
        Light light{};
        light.type = kLightPoint;
        light.position = vec3(2, 0, -5);
        light.intensity = vec3(1.0f);
        scene.lights = {light};
        expectMet(looking(scene, vec3(0), vec3(0, 0, -1), 1, 1024), row.value, 1e-3);
    }
}

// A furnace of air: what glows and swallows alike shows e / sigma_a, whatever it scatters; without either it adds up along the way.
TEST(Air, glowsByTheMetre)
{
    Scene scene;
    scene.media = {air(0.0f, 0.0f, 0.0f, vec3(-9, -9, -5), vec3(9, 9, -2))};
    scene.media[0].emission = vec3(0.5f);
    expectMet(looking(scene, vec3(0), vec3(0, 0, -1), {}, 1), 1.5);
    scene.media[0].absorption = vec3(0.4f);
    expectMet(looking(scene, vec3(0), vec3(0, 0, -1), {}, 1), 0.5 / 0.4 * (1.0 - std::exp(-1.2)));
    scene.media[0] = air(2.0f, 0.5f, 0.3f, vec3(-50), vec3(50));
    scene.media[0].emission = vec3(1.0f);
    expectMet(looking(scene, vec3(0), vec3(0, 0, -1), {}, 64), 2.0);
}

// A turned box: 2 sqrt(2) m through its middle, less off it, nothing beyond its edge.
TEST(Air, fillsAConvexBody)
{
    Scene scene;
    scene.sky.radiance = vec3(1.0f);
    scene.media = {air(0.0f, 0.5f, 0.0f, vec3(-1.5f), vec3(1.5f))};
    scene.media[0].planeCount = 4;
    for (const vec2 side : {vec2(1, 1), vec2(-1, 1), vec2(1, -1), vec2(-1, -1)})
        scene.mediumPlanes.push_back(vec4(normalize(vec3(side, 0.0f)), 1.0f));
    for (const float y : {0.0f, 0.7f, 1.45f})
        expectMet(looking(scene, vec3(-4, y, 0), vec3(1, 0, 0), {}), std::exp(-0.5 * 2.0 * std::max(std::sqrt(2.0) - double(y), 0.0)));
}

// H53: coefficients of 0 leave the mean as it was, although the path asks for its media at each flight; bits differ by rounding.
TEST(Air, ofNothingChangesNothing)
{
    Scene scene;
    scene.sky.radiance = vec3(0.3f);
    add(scene, plate(vec3(0.0f, -1.0f, 0.0f), 9.0f), matte(0.5f));
    const dvec2 without = looking(scene, vec3(0), vec3(0, -1, 0), {});
    scene.media = {air(0.0f, 0.0f, 0.5f, vec3(-99), vec3(99))};
    const dvec2 with_ = looking(scene, vec3(0), vec3(0, -1, 0), {});
    EXPECT_NEAR(with_.x, without.x, 4.0 * (with_.y + without.y) + 1e-6);
}

// H64: from a border, and through media that lie in each other and share borders.
TEST(Air, countsEveryBorderOnce)
{
    Scene scene;
    scene.sky.radiance = vec3(1.0f);
    scene.media = {air(0.0f, 0.2f, 0.0f, vec3(-9, -9, -6), vec3(9, 9, 0)), air(0.0f, 0.3f, 0.0f, vec3(-9, -9, -6), vec3(9, 9, -2)),
                   air(0.0f, 0.1f, 0.0f, vec3(-9, -9, -4), vec3(9, 9, -2))};
    const double wanted = std::exp(-0.2 * 6.0 - 0.3 * 4.0 - 0.1 * 2.0);
    for (const float z : {0.0f, 1e-5f, 1.0f}) expectMet(looking(scene, vec3(0, 0, z), vec3(0, 0, -1), {}), wanted);
}
}
