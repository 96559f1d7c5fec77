// From frame to frame: nothing new is made, histories remember, what is off is freed.
#include "tests/engine/graph/running.hpp"

namespace afterglow
{
class KeptTest : public Running
{
protected:
    // Adds 1 to what the last frame left.
    Texture count(Graph& graph, glm::uvec2 size)
    {
        const History history = graph.history("count", kFloat, size);
        graph.fullscreen("count", kShaders + "scale.frag").read(history.previous).write(history.current).push(1.0f).specialize(0, 1.0f);
        graph.output(history.current);
        return history.current;
    }
    float frame(glm::uvec2 size)
    {
        Graph graph;
        const Texture current = count(graph, size);
        stats = executor.run(graph);
        return executor.download(current).at(1, 1)[0];
    }
    FrameStats stats;
};

TEST_F(KeptTest, HistoriesRememberAndStartFromZero)
{
    EXPECT_EQ(frame({4, 4}), 1.0f);
    EXPECT_EQ(frame({4, 4}), 2.0f);
    EXPECT_EQ(frame({4, 4}), 3.0f);
    EXPECT_EQ(frame({8, 8}), 1.0f) << "a new shape has no past";
}

TEST_F(KeptTest, ASteadyFrameAllocatesNothing)
{
    std::uint32_t made = 0, pipelines = 0;
    std::uint64_t bytes = 0;
    for (int i = 0; i < 4; ++i) {
        Graph graph;
        const Texture counted = count(graph, {4, 4});
        const Texture a = graph.texture("a", kFloat, {4, 4}), b = graph.texture("b", kFloat, {4, 4});
        graph.fullscreen("a", kShaders + "scale.frag").read(counted).write(a).push(1.0f);
        graph.fullscreen("b", kShaders + "scale.frag").read(a).write(b).push(1.0f);
        graph.output(b);
        stats = executor.run(graph);
        if (i > 0) {
            EXPECT_EQ(gpu.memory.allocations(), made);
            EXPECT_EQ(stats.pipelines, pipelines);
            EXPECT_EQ(stats.gpuBytes, bytes);
        }
        made = gpu.memory.allocations();
        pipelines = stats.pipelines;
        bytes = stats.gpuBytes;
    }
}

TEST_F(KeptTest, WhatIsSwitchedOffIsFreed)
{
    const auto run = [&](bool on) {
        Graph graph;
        const Texture a = graph.texture("a", kFloat, {4, 4});
        graph.fullscreen("a", kShaders + "coordinates.frag").write(a);
        graph.output(a);
        if (on) count(graph, {256, 256});
        return executor.run(graph).gpuBytes;
    };
    const std::uint64_t before = run(false), with = run(true), after = run(false);
    EXPECT_GE(with, before + 2u * 256 * 256 * 16);
    EXPECT_EQ(after, before);
}
}
