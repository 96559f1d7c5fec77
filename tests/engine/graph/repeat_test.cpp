// Passes that repeat until a buffer says that nothing is left, and work groups counted by a buffer.
#include "engine/graph/schedule.hpp"
#include "tests/engine/graph/running.hpp"
#include <cstring>

namespace afterglow
{
// As countdown.comp has it.
struct Countdown {
    std::uint32_t left, groups[3], steps, invocations, arrived;
};

static Countdown read(const Executor& executor, const Buffer& buffer)
{
    Countdown result;
    std::memcpy(&result, executor.download(buffer).data(), sizeof(result));
    return result;
}

// From 5 down to 0, two passes together: the sixth pass finds nothing left and stands still.
TEST_F(Running, RepeatsUntilNothingIsLeft)
{
    for (const auto& [left, steps] : {std::pair(5u, 5u), {1u, 1u}, {0u, 0u}, {8u, 8u}}) {
        Graph graph;
        const Buffer buffer = graph.buffer("countdown", sizeof(Countdown)), copied = graph.buffer("copied", sizeof(Countdown));
        graph.compute("start", kShaders + "start.comp").write(buffer).push(left).dispatch(glm::uvec2(1));
        graph.repeat(buffer, [&] {
            for (int i = 0; i < 2; ++i) graph.compute("count down", kShaders + "countdown.comp").modify(buffer).dispatch(buffer, 4);
        });
        graph.compute("copy", kShaders + "copy.comp").read(buffer).write(copied).dispatch(glm::uvec2(1));
        graph.output(copied);
        const FrameStats stats = executor.run(graph);
        const Countdown counted = read(executor, copied);
        EXPECT_EQ(counted.left, 0u);
        EXPECT_EQ(counted.steps, steps);
        // A step for every number from `left` down, of as many groups of 8
        EXPECT_EQ(counted.invocations, 8u * left * (left + 1u) / 2u);
        EXPECT_EQ(stats.passes.size(), 3u) << "the two that count down are one row";
    }
}

TEST_F(Running, AsksForNoMoreGroupsThanTheDeviceDispatches)
{
    const auto dispatchDown = [&](std::uint32_t groups) {
        Graph graph;
        const Buffer buffer = graph.buffer("countdown", sizeof(Countdown));
        graph.compute("start", kShaders + "start.comp").write(buffer).push(0u).dispatch(glm::uvec2(1, groups));
        graph.output(buffer);
        executor.run(graph);
    };
    dispatchDown(1);
    EXPECT_DEATH(dispatchDown(gpu.device.limits.maxComputeWorkGroupCount[1] + 1), "start asks for more work groups than the device");
}

TEST(Repeats, KeepWhatTheyUseUntilTheLastTime)
{
    Graph graph;
    const Buffer left = graph.buffer("left", 16), early = graph.buffer("early", 64), late = graph.buffer("late", 64);
    graph.fill("left", left, 1);
    graph.repeat(left, [&] {
        graph.fill("early", early, 0);
        graph.compute("use early", "").read(early).modify(left).dispatch(glm::uvec2(1));
        graph.fill("late", late, 0);
        graph.compute("use late", "").read(late).modify(left).dispatch(glm::uvec2(1));
    });
    const Schedule schedule = compile(graph);
    EXPECT_NE(schedule.physicalOf[early.index], schedule.physicalOf[late.index]) << "the next time early comes after late";
}

TEST(Repeats, FindImagesAsTheyWereTheFirstTime)
{
    Graph graph;
    const Buffer left = graph.buffer("left", 16);
    const Texture image = graph.texture("image", kFloat, {4, 4});
    graph.compute("make", "").write(image).write(left).dispatch(glm::uvec2(4));
    graph.repeat(left, [&] { graph.compute("sample", "").read(image).modify(left).dispatch(glm::uvec2(4)); });
    EXPECT_DEATH(compile(graph), "sample is repeated, and would find an image in another layout");
}

TEST(Repeats, WaitForGroupsThatABufferCounts)
{
    Graph graph;
    const Buffer groups = graph.buffer("groups", 16), out = graph.buffer("out", 64);
    graph.compute("count", "").write(groups).dispatch(glm::uvec2(1));
    graph.compute("work", "").write(out).dispatch(groups, 0);
    graph.output(out);
    const Schedule schedule = compile(graph);
    ASSERT_EQ(schedule.passes[1].barriers.size(), 1u);
    EXPECT_EQ(schedule.passes[1].barriers[0].after.stages, VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT);
    EXPECT_EQ(schedule.passes[1].barriers[0].after.access, VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT);
}
}
