// What the path estimator must get right where lights have a size, lamps are cut out, and only cameras see: small levels made here.
#include "baker/baker.hpp"
#include "shaders/color.h"
#include "shapes.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
static Light lamp(uint type, vec3 position)
{
    Light light{};
    light.type = type;
    light.position = position;
    light.direction = vec3(0.0f, -1.0f, 0.0f);
    light.intensity = vec3(1.0f);
    return light;
}

// Irradiance on the floor's origin, from above.
static PointIrradiance onTheFloor(const Scene& scene, int samples = 16384)
{
    ProbePoint point;
    point.normal = vec3(0.0f, 1.0f, 0.0f);
    Progress silent(ProgressStyle::none);
    return probeTruth(scene, {point}, samples, 5, 0, silent)[0];
}

static void expectIrradiance(const Scene& scene, float truth)
{
    PointIrradiance found = onTheFloor(scene);
    EXPECT_NEAR(found.value[0].x, truth, 4.0f * found.error[0].x + 1e-4f * truth) << "standard error " << found.error[0].x;
}

// The mean of a small picture from the origin upwards, and its standard error.
static dvec2 lookingUp(const Scene& scene, int samples)
{
    TruthOptions options;
    options.camera.toWorld = mat4(vec4(1, 0, 0, 0), vec4(0, 0, 1, 0), vec4(0, -1, 0, 0), vec4(0, 0, 0, 1));
    options.camera.fovY = 0.02f;
    options.size = ivec2(16, 16);
    options.samples = samples;
    Progress silent(ProgressStyle::none);
    Image image = truth(scene, options, silent);
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < 256; i++) {
        double pixel = double(image.pixels[std::size_t(i) * 3]);
        sum += pixel;
        squares += pixel * pixel;
    }
    double mean = sum / 256.0;
    return dvec2(mean, std::sqrt(std::max(squares / 256.0 - mean * mean, 0.0) / 255.0));
}

// E = pi L (R / d)^2 = I / d^2 about the axis of a sphere wholly above the horizon, however near.
TEST(Transport, aNearSphereLightLosesNothing)
{
    Scene scene;
    add(scene, plate(vec3(0.0f), 5.0f), matte(0.0f));
    scene.lights = {lamp(kLightPoint, vec3(0.0f, 0.7f, 0.0f))};
    scene.lights[0].radius = 0.6f;
    expectIrradiance(scene, 1.0f / 0.49f);
}

TEST(Transport, aWideSunLosesNothing)
{
    Scene scene;
    add(scene, plate(vec3(0.0f), 5.0f), matte(0.0f));
    scene.lights = {lamp(kLightDirectional, vec3(0.0f))};
    scene.lights[0].sinAngle = 0.7f;
    expectIrradiance(scene, 1.0f);
}

// H51: what the mask takes away does not shine, what alpha halves shines half.
TEST(Transport, aCutOutLampShinesWithWhatIsThere)
{
    float whole = 0.0f;
    for (float alpha : {1.0f, 0.25f, 0.0f}) {
        Scene scene;
        add(scene, plate(vec3(0.0f), 5.0f), matte(0.0f));
        Material shining = matte(0.0f);
        shining.emission = vec3(1.0f);
        shining.baseColor.a = alpha;
        shining.flags |= alpha == 0.0f ? kMaterialAlphaMask : kMaterialAlphaBlend;
        shining.alphaCutoff = 0.5f;
        add(scene, plate(vec3(0.0f, 1.0f, 0.0f), 0.5f, /* up= */ false), shining);
        if (alpha == 1.0f) whole = onTheFloor(scene).value[0].x;
        expectIrradiance(scene, alpha * whole);
    }
    EXPECT_GT(whole, 0.5f);
}

// KHR_materials_unlit: a mirror shows it to the camera, but nothing is lit by it.
TEST(Transport, anUnlitSurfaceLightsNothing)
{
    Scene scene;
    Material mirror = matte(1.0f), unlit = matte(1.0f);
    mirror.flags = 0;
    mirror.metallic = 1.0f;
    mirror.roughness = 0.0f;
    unlit.flags = kMaterialUnlit;
    add(scene, plate(vec3(0.0f), 0.5f), matte(0.5f));
    add(scene, plate(vec3(0.0f, -1.0f, 0.0f), 9.0f), unlit);
    add(scene, plate(vec3(0.0f, 2.0f, 0.0f), 9.0f, /* up= */ false), mirror);
    EXPECT_EQ(onTheFloor(scene, 4096).value[0].x, 0.0f);
    scene.objects.erase(scene.objects.begin()); // without the floor, a camera sees the unlit plane in the mirror
    EXPECT_NEAR(lookingUp(scene, 4).x, 1.0, 1e-5);
}

// A camera does not see punctual lights: neither directly nor through a clear pane.
TEST(Transport, aPaneShowsNoLamp)
{
    Scene scene;
    Material pane = matte(1.0f);
    pane.flags = 0;
    pane.transmission = 1.0f;
    pane.roughness = 0.0f;
    add(scene, plate(vec3(0.0f, 1.0f, 0.0f), 1.0f), pane);
    scene.lights = {lamp(kLightPoint, vec3(0.0f, 5.0f, 0.0f))};
    scene.lights[0].radius = 0.5f;
    EXPECT_EQ(lookingUp(scene, 16).x, 0.0);
}

// In a mirror a sphere light is seen, dimmed by the air in between: L exp(-sigma d), with 2 m up and 1 m back down to its surface.
TEST(Transport, aLampInAMirrorIsDimmedUpToTheLamp)
{
    Scene scene;
    Material mirror = matte(1.0f);
    mirror.flags = 0;
    mirror.metallic = 1.0f;
    mirror.roughness = 0.0f;
    add(scene, plate(vec3(0.0f, 2.0f, 0.0f), 1.0f, /* up= */ false), mirror);
    scene.lights = {lamp(kLightPoint, vec3(0.0f, 0.5f, 0.0f))};
    scene.lights[0].radius = 0.5f;
    Medium air{};
    air.absorption = vec3(0.4f);
    air.lower = vec3(-9.0f), air.upper = vec3(9.0f);
    scene.media = {air};
    double radiance = 1.0 / (double(kPi) * 0.25);
    dvec2 found = lookingUp(scene, 64);
    EXPECT_NEAR(found.x, radiance * std::exp(-0.4 * 3.0), 4.0 * found.y + 1e-3);
}

// H63: a cloud that swallows nothing returns all of a white sky, however thick.
TEST(Transport, aWhiteCloudIsAsWhiteAsItsSky)
{
    Scene scene;
    scene.sky.radiance = vec3(1.0f);
    Medium cloud{};
    cloud.scattering = vec3(40.0f);
    cloud.lower = vec3(-9.0f, 1.0f, -9.0f), cloud.upper = vec3(9.0f, 2.0f, 9.0f);
    scene.media = {cloud};
    dvec2 found = lookingUp(scene, 16);
    EXPECT_NEAR(found.x, 1.0, 4.0 * found.y + 1e-5) << "standard error " << found.y;
}
}
