// Truth on the GPU, organised as is the device's default, against closed forms; that it is the CPU's is asked in
// tests/engine/app/two_tracers_test.cpp.
#include "engine/effects/truth/truth.hpp"
#include "engine/graph/executor.hpp"
#include "engine/scene/picture.hpp"
#include "shaders/color.h"
#include "tests/engine/gpu/validated.hpp"
#include "tests/engine/upload/toy_level.hpp"
#include <cmath>

namespace afterglow
{
class TruthOfGpu : public Validated
{
protected:
    Scene scene;
    uvec2 size{16, 16};
    Executor executor{gpu};
    TracedSamples samples;
    Tracing tracing = Tracing::automatic;

    void SetUp() override
    {
        if (!canTrace(gpu.device, tracing)) GTEST_SKIP() << gpu.device.deviceName << " traces no rays";
        tracing = tracingOn(gpu.device, tracing);
    }

    // The pictures that a camera sees in so many frames, each the mean of the samples so far; the last of them.
    Image traced(const Camera& camera, TruthParameters parameters, int frames = 1)
    {
        GpuScene uploaded = uploadScene(gpu, scene, instances(scene), scene.lights);
        uploaded.rays = buildRays(gpu, scene, instances(scene), RaysFor::paths);
        const GpuPaths paths = uploadPaths(gpu, scene, instances(scene), uploaded.rays);
        const GpuLevel level(gpu, std::move(uploaded), {});
        Image image;
        for (int i = 0; i < frames; ++i) {
            Graph graph;
            const Texture mean =
                truth(graph, {gpu.memory, level, paths, tracing}, pictureOf(camera, size, parameters.seed, 1), samples, parameters);
            graph.output(mean);
            executor.run(graph, level.set);
            image = executor.download(mean);
        }
        return image;
    }
    static TruthParameters of(uint count, uint perFrame)
    {
        TruthParameters p = defaultTruthParameters();
        p.samples = count;
        p.perFrame = perFrame;
        return p;
    }

    struct Statistics {
        double mean = 0, error = 0; // of the mean
    };
    static Statistics of(const Image& image)
    {
        double sum = 0, squares = 0;
        const int pixels = image.width * image.height;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const double v = double(image.at(x, y)[1]);
                EXPECT_TRUE(std::isfinite(v));
                sum += v, squares += v * v;
            }
        const double mean = sum / pixels;
        return {mean, std::sqrt(std::max(squares / pixels - mean * mean, 0.0) / (pixels - 1))};
    }
    static void expectMean(const Image& image, double wanted)
    {
        const Statistics s = of(image);
        EXPECT_NEAR(s.mean, wanted, 3.5 * s.error + 1e-5 * wanted);
        EXPECT_LT(s.error, 0.05 * wanted); // or it says nothing
    }
};

// Every direction of every vertex sees emission e and albedo a: e (1 + a + a^2 + ...) = e / (1 - a).
TEST_F(TruthOfGpu, OfAFurnaceIsTheGeometricSeries)
{
    Material wall = matte(vec3(0.5f));
    wall.emission = vec3(1.0f);
    addRoom(scene, vec3(-1), vec3(1), addMaterial(scene, wall));
    expectMean(traced(lookAt(vec3(0), vec3(0, 0, -1)), of(16, 4), 4), 2.0);
}

// Cut after `bounces` surfaces that scatter: one more is lit directly.
TEST_F(TruthOfGpu, EndsAfterItsBounces)
{
    Material wall = matte(vec3(0.5f));
    wall.emission = vec3(1.0f);
    addRoom(scene, vec3(-1), vec3(1), addMaterial(scene, wall));
    TruthParameters one = of(16, 16);
    one.bounces = 1;
    expectMean(traced(lookAt(vec3(0), vec3(0, 0, -1)), one), 1.0 + 0.5 + 0.25);
}

// E = 3 square on a Lambertian floor of albedo 0.6: L = 0.6 E / pi at every pixel, whatever the random numbers.
TEST_F(TruthOfGpu, OfAFloorInTheSunIsExact)
{
    addQuad(scene, vec3(-9, 0, -9), vec3(0, 0, 18), vec3(18, 0, 0), addMaterial(scene, matte(vec3(0.6f))));
    addLight(scene, sunLight(vec3(0, -1, 0), vec3(3.0f)));
    const Image image = traced(lookAt(vec3(0, 3, 0), vec3(0)), of(2, 1), 2);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) EXPECT_NEAR(image.at(x, y)[0], 0.6f * 3.0f * kInvPi, 1e-5f);
}

TEST_F(TruthOfGpu, OfNothingIsTheSky)
{
    scene.sky.radiance = vec3(0.25f, 0.5f, 1.0f);
    const Image image = traced(lookAt(vec3(0), vec3(0, 0, -1)), of(3, 1), 3);
    for (int c = 0; c < 3; ++c) EXPECT_FLOAT_EQ(image.at(5, 9)[c], scene.sky.radiance[c]);
}

// A sky painted evenly is a uniform one, although its directions are chosen otherwise; a black half of it leaves a floor half of the light
// of the other half: E = pi L / 2 where the horizon divides it upright.
TEST_F(TruthOfGpu, OfAPaintedSkyIsItsIntegral)
{
    scene.sky.radiance = vec3(1.0f);
    scene.sky.image = Image(16, 8, 3);
    for (float& value : scene.sky.image.pixels) value = 2.0f;
    addQuad(scene, vec3(-900, 0, -900), vec3(0, 0, 1800), vec3(1800, 0, 0), addMaterial(scene, matte(vec3(0.5f))));
    const Camera camera = lookAt(vec3(0, 3, 0), vec3(0));
    expectMean(traced(camera, of(64, 64)), 1.0);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            for (int c = 0; c < 3; ++c) scene.sky.image.at(x, y)[c] = 0.0f;
    samples.count = 0;
    expectMean(traced(camera, of(64, 64)), 0.5);
}

// A sun in the sky's image is brighter than a half float can say.
TEST_F(TruthOfGpu, KeepsTheRangeOfTheSky)
{
    scene.sky.radiance = vec3(1.0f);
    scene.sky.image = Image(8, 4, 3);
    for (float& value : scene.sky.image.pixels) value = 1e6f;
    const Image image = traced(lookAt(vec3(0), vec3(0, 0, -1)), of(1, 1));
    for (int c = 0; c < 3; ++c) EXPECT_FLOAT_EQ(image.at(3, 3)[c], 1e6f);
}

// A lamp is no surface: a camera does not see it, and what it lights does.
TEST_F(TruthOfGpu, ACameraSeesNoLamp)
{
    Light lamp = pointLight(vec3(0, 0, -2), vec3(10.0f));
    lamp.radius = 0.5f;
    addLight(scene, lamp);
    EXPECT_EQ(of(traced(lookAt(vec3(0), vec3(0, 0, -1)), of(1, 1))).mean, 0.0);
}

// Frame by frame or all at once: the same samples in the same order.
TEST_F(TruthOfGpu, AddsUpOverFrames)
{
    Material wall = matte(vec3(0.7f)), lamp = matte(vec3(0.0f));
    lamp.emission = vec3(5.0f);
    addRoom(scene, vec3(-1), vec3(1), addMaterial(scene, wall));
    addQuad(scene, vec3(-0.3f, 0.99f, -0.3f), vec3(0.6f, 0, 0), vec3(0, 0, 0.6f), addMaterial(scene, lamp));
    const Camera camera = lookAt(vec3(0, 0, 0.9f), vec3(0, 0, -1));
    const Image atOnce = traced(camera, of(4, 4));
    EXPECT_EQ(samples.count, 4u);
    samples.count = 0;
    EXPECT_EQ(traced(camera, of(4, 1), 4).pixels, atOnce.pixels);
    EXPECT_EQ(traced(camera, of(4, 1), 2).pixels, atOnce.pixels) << "what is complete stays";
    EXPECT_NE(traced(camera, of(8, 4)).pixels, atOnce.pixels) << "more go on from there";
    EXPECT_EQ(samples.count, 8u);
}

// H89: a sum of floats alone stands still long before: 0.1 added to 2^18 changes it by 0.094 or 0.125.
TEST_F(TruthOfGpu, ManySamplesLoseNothing)
{
    scene.sky.radiance = vec3(0.1f);
    size = {1, 1};
    if (gpu.device.rayQuery) tracing = Tracing::kernel; // a wavefront of one path takes as many steps
    const Image image = traced(lookAt(vec3(0), vec3(0, 0, -1)), of(1u << 22, 1u << 18), 16);
    EXPECT_EQ(samples.count, 1u << 22);
    for (int c = 0; c < 3; ++c) EXPECT_FLOAT_EQ(image.at(0, 0)[c], 0.1f);
}

TEST_F(TruthOfGpu, BeginsAnewWhenThePictureIsAnother)
{
    scene.sky.radiance = vec3(1.0f);
    const auto countAfter = [&](const Camera& camera, TruthParameters parameters) {
        traced(camera, parameters);
        return samples.count;
    };
    const Camera camera = lookAt(vec3(0), vec3(0, 0, -1));
    EXPECT_EQ(countAfter(camera, of(9, 1)), 1u);
    EXPECT_EQ(countAfter(camera, of(9, 1)), 2u);
    EXPECT_EQ(countAfter(lookAt(vec3(0, 0, 1e-3f), vec3(0, 0, -1)), of(9, 1)), 1u);
    TruthParameters other = of(9, 1);
    other.seed = 7;
    EXPECT_EQ(countAfter(camera, other), 1u);
    EXPECT_EQ(countAfter(camera, other), 2u);
    size = {8, 8};
    EXPECT_EQ(countAfter(camera, other), 1u);
}

// Absorption of 0.5 / m before a wall of radiance 1 at 2 m: exp(-1) on every path; a path is not noisier for it.
TEST_F(TruthOfGpu, ThroughAirIsDimmedByIt)
{
    Material wall = matte(vec3(0.0f));
    wall.emission = vec3(1.0f);
    addQuad(scene, vec3(-50, -50, -2), vec3(100, 0, 0), vec3(0, 100, 0), addMaterial(scene, wall));
    Medium air{};
    air.absorption = vec3(0.5f);
    air.lower = vec3(-100), air.upper = vec3(100);
    scene.media.push_back(air);
    Camera camera = lookAt(vec3(0), vec3(0, 0, -1), 0.01f); // a pencil of rays: all 2 m long to 1e-5
    const Image image = traced(camera, of(4, 4));
    expectMean(image, std::exp(-1.0));
}
}
