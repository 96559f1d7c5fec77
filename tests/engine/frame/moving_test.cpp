// Frame after frame: what holds still is drawn once and allocates nothing, what moves is drawn where it is.
#include "tests/engine/frame/frame.hpp"

namespace afterglow
{
// An object that is moved takes its shadow along: the maps are drawn again, once.
TEST_F(FrameTest, WhatIsMovedIsDrawnElsewhere)
{
    addLight(scene, pointLight(vec3(0, 1, 0), vec3(1.0f)));
    addQuad(scene, vec3(-0.3f, -1.0f, -0.3f), vec3(0, 0, 0.6f), vec3(0.6f, 0, 0), 0);
    Settings settings;
    settings.size = {32, 24};
    Stage stage = makeStage(gpu, scene, nullptr, settings);
    Executor executor(gpu);
    const auto frame = [&] {
        Graph graph;
        const Pictures pictures = drawFrame(graph, stage, nextView(stage, camera, settings), settings);
        graph.output(pictures.displayed);
        stats = executor.run(graph, stage.level->set);
    };
    frame();
    frame();
    EXPECT_FALSE(ran("shadow"));
    EXPECT_FALSE(ran("antialias.motion"));
    scene.objects.back().toWorld[3] = dvec4(0.5, 0.2, 0.0, 1.0);
    move(gpu, stage, scene, uint(scene.objects.size() - 1));
    frame();
    EXPECT_TRUE(ran("shadow"));
    EXPECT_TRUE(ran("antialias.motion"));
    frame();
    EXPECT_FALSE(ran("shadow"));
    EXPECT_FALSE(ran("antialias.motion"));
}

// What rays meet and what mirrors show is where it is now: the picture is that of a level which had it there from the start.
TEST_F(FrameTest, RaysAndMirrorsFollowWhatIsMoved)
{
    addLight(scene, pointLight(vec3(0, 1, 0), vec3(1.0f)));
    addQuad(scene, vec3(-0.3f, -1.0f, -0.3f), vec3(0, 0, 0.6f), vec3(0.6f, 0, 0), 0);
    const uint plate = uint(scene.objects.size() - 1);
    Material silver = matte(vec3(1.0f));
    silver.flags = kMaterialMirror;
    silver.metallic = 1.0f;
    silver.roughness = 0.0f;
    addQuad(scene, vec3(1.5f, -1, -1), vec3(0, 0, 2), vec3(0, 2, 0), addMaterial(scene, silver)); // faces -x
    const uint mirror = uint(scene.objects.size() - 1);
    Settings settings;
    settings.size = {32, 24};
    settings.shadowMethod = gpu.device.rayQuery ? ShadowMethod::ray : ShadowMethod::map;
    Executor executor(gpu);
    const auto frame = [&](Stage& stage) {
        Graph graph;
        const Texture radiance = drawFrame(graph, stage, makeView(camera, settings.size), settings).radiance;
        graph.output(radiance);
        executor.run(graph, stage.level->set);
        return executor.download(radiance).pixels;
    };
    Stage stage = makeStage(gpu, scene, nullptr, settings);
    const std::vector<float> before = frame(stage);
    scene.objects[plate].toWorld[3] = dvec4(0.5, 0.25, 0.0, 1.0);
    scene.objects[mirror].toWorld[3] = dvec4(-0.5, 0.0, -0.25, 1.0);
    for (const uint object : {plate, mirror}) move(gpu, stage, scene, object);
    forget(stage);
    const std::vector<float> after = frame(stage);
    EXPECT_NE(after, before);
    Stage there = makeStage(gpu, scene, nullptr, settings);
    EXPECT_EQ(after, frame(there));
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
}
