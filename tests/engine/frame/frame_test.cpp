// Whole frames: off costs nothing, forced on changes nothing, odd sizes and empty levels draw, a steady frame allocates nothing.
#include "engine/core/error.hpp"
#include "engine/frame/frame.hpp"
#include "engine/gpu/readback.hpp"
#include "tests/engine/gpu/validated.hpp"
#include "tests/engine/upload/toy_level.hpp"
#include <cmath>

namespace afterglow
{
class FrameTest : public Validated
{
protected:
    // A white room lit by an emissive ceiling panel, seen from a corner; baked or not.
    FrameTest()
    {
        addRoom(scene, vec3(-2), vec3(2), addMaterial(scene, matte(vec3(0.6f, 0.5f, 0.4f))));
        Material lamp = matte(vec3(0.0f));
        lamp.emission = vec3(5.0f);
        addQuad(scene, vec3(-0.5f, 1.9f, -0.5f), vec3(1, 0, 0), vec3(0, 0, 1), addMaterial(scene, lamp));
        camera = lookAt(vec3(-1.5f, 0, 1.5f), vec3(1, -0.5f, -1));
    }

    Image8 draw(const Scene& level, const Baked* baked, const std::string& effects, uvec2 size = {64, 48})
    {
        Settings settings;
        settings.size = size;
        settings.effects = parseOverrides(effects);
        Stage stage = makeStage(gpu, level, baked, settings);
        Graph graph;
        const Pictures pictures = drawFrame(graph, stage, makeView(camera, size), settings);
        graph.output(pictures.displayed);
        Executor executor(gpu);
        stats = executor.run(graph, stage.level->set);
        return readback8(gpu.memory, executor.image(pictures.displayed));
    }

    bool ran(const std::string& pass) const
    {
        for (const PassStats& p : stats.passes)
            if (p.name.rfind(pass, 0) == 0) return true;
        return false;
    }

    Scene scene;
    Camera camera;
    FrameStats stats;
};

TEST_F(FrameTest, WhatIsOffHasNoPassAndNoMemory)
{
    draw(scene, nullptr, "auto");
    for (const char* pass : {"shadow", "reflection", "fog", "lighting.clear", "geometry.masked"}) EXPECT_FALSE(ran(pass)) << pass;
    const std::uint64_t automatic = stats.gpuBytes;
    draw(scene, nullptr, "none");
    EXPECT_EQ(stats.gpuBytes, automatic);
}

// For every effect that the plan leaves off: forced on, no pixel changes by more than one step of 8 bits.
TEST_F(FrameTest, ForcingAnEffectThatIsNotCalledForChangesNothing)
{
    const Baked baked = bakedEvenly(scene, vec3(0.7f));
    const Image8 plain = draw(scene, &baked, "auto");
    const Plan planned = plan(needs(scene), evidenceOf(scene, &baked), {});
    for (const char* effect : {"masked", "shadow", "probes", "reflections", "reflection", "clear", "fog"}) {
        ASSERT_FALSE(planned.on(effect)) << effect;
        const Image8 forced = draw(scene, &baked, std::string("+") + effect);
        ASSERT_EQ(forced.pixels.size(), plain.pixels.size());
        int largest = 0;
        for (std::size_t i = 0; i < plain.pixels.size(); ++i)
            largest = std::max(largest, std::abs(int(forced.pixels[i]) - int(plain.pixels[i])));
        EXPECT_LE(largest, 1) << effect;
    }
}

TEST_F(FrameTest, IsNeitherBlackNorWhite)
{
    const Baked baked = bakedEvenly(scene, vec3(0.7f));
    const Image8 picture = draw(scene, &baked, "auto");
    double sum = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) sum += i % 4 == 3 ? 0 : picture.pixels[i];
    const double mean = sum / (double(picture.pixels.size()) * 0.75);
    EXPECT_GT(mean, 40);
    EXPECT_LT(mean, 215);
}

// H72: one pixel, one row, odd sizes.
TEST_F(FrameTest, DrawsAtAnySize)
{
    for (const uvec2 size : {uvec2(1, 1), uvec2(1, 7), uvec2(33, 1), uvec2(37, 23)}) {
        const Image8 picture = draw(scene, nullptr, "auto,+fog", size);
        EXPECT_EQ(picture.width, int(size.x));
        EXPECT_EQ(picture.height, int(size.y));
    }
}

// H17: nothing at all, lights only.
TEST_F(FrameTest, AnEmptyLevelDrawsItsSky)
{
    Scene empty;
    empty.sky.radiance = vec3(0.5f);
    addLight(empty, sunLight(vec3(0, -1, 0), vec3(1.0f)));
    const Image8 picture = draw(empty, nullptr, "auto");
    EXPECT_GT(picture.pixels[0], 0);
    EXPECT_EQ(picture.pixels[0], picture.pixels[picture.pixels.size() - 4]);
}

TEST_F(FrameTest, ASteadyFrameAllocatesNothingAndKeepsItsShadows)
{
    addLight(scene, pointLight(vec3(0), vec3(1.0f)));
    Settings settings;
    settings.size = {32, 32};
    Stage stage = makeStage(gpu, scene, nullptr, settings);
    Executor executor(gpu);
    std::uint32_t allocations = 0;
    std::vector<std::uint8_t> first;
    for (int i = 0; i < 4; ++i) {
        Graph graph;
        const Pictures pictures = drawFrame(graph, stage, makeView(camera, settings.size), settings);
        graph.output(pictures.displayed);
        stats = executor.run(graph, stage.level->set);
        const Image8 picture = readback8(gpu.memory, executor.image(pictures.displayed));
        if (i == 0) {
            EXPECT_TRUE(ran("shadow"));
            first = picture.pixels;
        } else {
            EXPECT_FALSE(ran("shadow")) << "a level holds still";
            EXPECT_EQ(picture.pixels, first);
        }
        if (i == 2) allocations = gpu.memory.allocations();
    }
    EXPECT_LE(gpu.memory.allocations(), allocations + 2) << "two buffers of the readback";
}

// Cascades are drawn when the eye has moved far enough to need it, and only they; without a sun they cost nothing.
TEST_F(FrameTest, CascadesFollowTheEye)
{
    draw(scene, nullptr, "auto,+shadow");
    const std::uint64_t without = stats.gpuBytes;
    draw(scene, nullptr, "auto,+shadow,+shadow.cascades");
    EXPECT_EQ(stats.gpuBytes, without);

    addQuad(scene, vec3(-200, -3, -200), vec3(0, 0, 400), vec3(400, 0, 0), 0);
    addLight(scene, sunLight(vec3(0.5f, -1, 0.2f), vec3(1.0f)));
    Settings settings;
    settings.size = {32, 32};
    settings.effects = parseOverrides("+shadow.cascades");
    Stage stage = makeStage(gpu, scene, nullptr, settings);
    Executor executor(gpu);
    const auto frame = [&](float x) {
        Graph graph;
        graph.output(drawFrame(graph, stage, makeView(lookAt(vec3(x, 0, 0), vec3(x + 1, 0, 0)), settings.size), settings).displayed);
        stats = executor.run(graph, stage.level->set);
    };
    frame(0.0f);
    EXPECT_TRUE(ran("shadow"));
    EXPECT_FALSE(ran("shadow.cascades"));
    frame(0.0f);
    EXPECT_FALSE(ran("shadow")) << "the eye rests";
    frame(5.0f);
    EXPECT_TRUE(ran("shadow.cascades"));
    frame(5.0f);
    EXPECT_FALSE(ran("shadow"));
}

// H66: a camera that has no picture is refused in words.
TEST_F(FrameTest, RefusesACameraWithoutAPicture)
{
    Camera flat = camera;
    flat.nearPlane = 0.0f;
    EXPECT_THROW(makeView(flat, {16, 16}), Error);
    flat = camera;
    flat.fovY = 3.2f;
    EXPECT_THROW(makeView(flat, {16, 16}), Error);
}

TEST_F(FrameTest, ARadianceOutputNeedsNoDisplay)
{
    Settings settings;
    settings.size = {16, 16};
    Stage stage = makeStage(gpu, scene, nullptr, settings);
    Graph graph;
    graph.output(drawFrame(graph, stage, makeView(camera, settings.size), settings).radiance);
    Executor executor(gpu);
    stats = executor.run(graph, stage.level->set);
    EXPECT_FALSE(ran("display"));
}
}
