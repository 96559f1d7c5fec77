// Ray programs in a frame: their table is found by the device, their barriers are those of their stages.
#include "engine/graph/schedule.hpp"
#include "tests/engine/graph/running.hpp"

namespace afterglow
{
TEST(RayPrograms, WhatTheyWriteWaitsInTheirStage)
{
    Graph graph;
    const Buffer a = graph.buffer("a", 64), b = graph.buffer("b", 64);
    graph.trace("rays", {}).write(a).dispatch(glm::uvec2(4));
    graph.compute("read", "").read(a).write(b).dispatch(glm::uvec2(4));
    graph.output(b);
    const Schedule schedule = compile(graph);
    ASSERT_EQ(schedule.passes[1].barriers.size(), 1u);
    EXPECT_EQ(schedule.passes[1].barriers[0].before.stages, VK_PIPELINE_STAGE_2_RAY_TRACING_SHADER_BIT_KHR);
    EXPECT_EQ(schedule.passes[1].barriers[0].after.stages, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT);
}

TEST(RayPrograms, AreListedOnceEach)
{
    Graph graph;
    graph.trace("rays", {"a.rgen", {"b.rmiss"}, {{"c.rchit", ""}, {}, {"c.rchit", "d.rahit"}}});
    EXPECT_EQ(graph.passes[0].key.shaders, (std::vector<std::string>{"a.rgen", "b.rmiss", "c.rchit", "d.rahit"}));
    EXPECT_EQ(graph.passes[0].key.hits.size(), 3u);
}

// A program for each texel, no ray: of 13 x 7 invocations each writes its place.
TEST_F(Running, RayProgramsWriteWhatFragmentsRead)
{
    if (!gpu.device.rayPipeline) GTEST_SKIP() << gpu.device.deviceName << " has no ray-tracing pipelines";
    const std::uint32_t before = gpu.pipelines.count();
    for (int frame = 0; frame < 2; ++frame) {
        Graph graph;
        const Texture places = graph.texture("places", kFloat, {13, 7}), twice = graph.texture("twice", kFloat, {13, 7});
        graph.trace("places", {kShaders + "places.rgen", {kShaders + "nothing.rmiss"}, {{}}})
            .write(places)
            .push(0.5f)
            .dispatch(places.size());
        graph.fullscreen("times 2", kShaders + "scale.frag").read(places).write(twice).push(2.0f);
        graph.output(twice);
        executor.run(graph);
        const Image result = executor.download(twice);
        for (int y = 0; y < 7; ++y)
            for (int x = 0; x < 13; ++x) {
                EXPECT_EQ(result.at(x, y)[0], 2.0f * float(x) + 1.0f);
                EXPECT_EQ(result.at(x, y)[1], 2.0f * float(y) + 1.0f);
            }
    }
    EXPECT_EQ(gpu.pipelines.count(), before + 2u);
}
}
