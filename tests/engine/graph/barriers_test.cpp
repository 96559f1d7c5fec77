// Barriers, without a GPU: where they stand, what they wait for, and where none is needed.
#include "engine/graph/schedule.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
static const VkFormat kFormat = VK_FORMAT_R8G8B8A8_UNORM;
constexpr VkImageLayout kColor = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
constexpr VkImageLayout kSampled = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;

TEST(Barriers, DrawnThenSampled)
{
    Graph graph;
    const Texture a = graph.texture("a", kFormat, {4, 4}), b = graph.texture("b", kFormat, {4, 4});
    graph.fullscreen("a", "").write(a);
    graph.fullscreen("b", "").read(a).write(b);
    graph.output(b);
    const Schedule schedule = compile(graph);

    // First use: from nothing, waiting for nothing.
    ASSERT_EQ(schedule.passes[0].barriers.size(), 1u);
    EXPECT_EQ(schedule.passes[0].barriers[0].before, State{});
    EXPECT_EQ(schedule.passes[0].barriers[0].after.layout, kColor);

    ASSERT_EQ(schedule.passes[1].barriers.size(), 2u);
    const Barrier& read = schedule.passes[1].barriers[0];
    EXPECT_EQ(read.before.stages, VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT);
    EXPECT_TRUE(read.before.access & VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT);
    EXPECT_EQ(read.before.layout, kColor);
    EXPECT_EQ(read.after.stages, VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT);
    EXPECT_EQ(read.after.access, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT);
    EXPECT_EQ(read.after.layout, kSampled);

    // The output goes to its rest.
    ASSERT_EQ(schedule.last.size(), 1u);
    EXPECT_EQ(schedule.last[0].after.layout, kRestLayout);
}

TEST(Barriers, ASecondReaderInTheSameStageNeedsNone)
{
    Graph graph;
    const Texture a = graph.texture("a", kFormat, {4, 4}), b = graph.texture("b", {kFormat, {8, 8, 1}}),
                  c = graph.texture("c", kFormat, {2, 2});
    graph.fullscreen("a", "").write(a);
    graph.fullscreen("b", "").read(a).write(b);
    graph.fullscreen("c", "").read(a).read(b).write(c);
    graph.output(c);
    const Schedule schedule = compile(graph);
    for (const Barrier& barrier : schedule.passes[2].barriers) EXPECT_NE(barrier.physical, schedule.physicalOf[a.index]);
}

TEST(Barriers, AReaderInAnotherStageWaitsForTheFirst)
{
    Graph graph;
    const Texture a = graph.texture("a", kFormat, {4, 4}), b = graph.texture("b", kFormat, {8, 8});
    const Buffer histogram = graph.buffer("histogram", 1024);
    graph.fullscreen("a", "").write(a);
    graph.fullscreen("b", "").read(a).write(b);
    graph.compute("histogram", "").read(a).read(b).write(histogram).dispatch(glm::uvec2(4));
    graph.output(histogram);
    const Schedule schedule = compile(graph);
    bool found = false;
    for (const Barrier& barrier : schedule.passes[2].barriers) {
        if (barrier.physical != schedule.physicalOf[a.index]) continue;
        found = true;
        EXPECT_EQ(barrier.before.layout, barrier.after.layout);
        EXPECT_EQ(barrier.before.stages, VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT);
        EXPECT_EQ(barrier.after.stages, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT);
    }
    EXPECT_TRUE(found);
}

TEST(Barriers, WriteAfterReadIsOrderedWithoutAFlush)
{
    Graph graph;
    const Buffer a = graph.buffer("a", 64), b = graph.buffer("b", 128);
    graph.fill("zero a", a, 0);
    graph.compute("read a", "").read(a).write(b).dispatch(glm::uvec2(1));
    graph.fill("one a", a, 1);
    graph.output(a);
    graph.output(b);
    const Schedule schedule = compile(graph);
    ASSERT_EQ(schedule.passes.size(), 3u);
    ASSERT_EQ(schedule.passes[2].barriers.size(), 1u);
    const State& before = schedule.passes[2].barriers[0].before;
    EXPECT_TRUE(before.stages & VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT);
    EXPECT_FALSE(before.access & VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
}

TEST(Barriers, MipsAreFollowedOneByOne)
{
    Graph graph;
    const Texture chain = graph.texture("chain", {kFormat, {8, 8, 1}, 3});
    graph.fullscreen("mip 0", "").write(chain.mip(0));
    graph.fullscreen("mip 1", "").read(chain.mip(0)).write(chain.mip(1));
    graph.fullscreen("mip 2", "").read(chain.mip(1)).write(chain.mip(2));
    graph.output(chain);
    const Schedule schedule = compile(graph);
    ASSERT_EQ(schedule.passes.size(), 3u);
    ASSERT_EQ(schedule.passes[2].barriers.size(), 2u);
    EXPECT_EQ(schedule.passes[2].barriers[0].range, (ImageRange{1, 1, 0, 1}));
    EXPECT_EQ(schedule.passes[2].barriers[0].before.layout, kColor);
    EXPECT_EQ(schedule.passes[2].barriers[1].range, (ImageRange{2, 1, 0, 1}));
    EXPECT_EQ(schedule.passes[2].barriers[1].before.layout, VK_IMAGE_LAYOUT_UNDEFINED);
}

TEST(Barriers, ANewTenantWaitsForTheOldOneButKeepsNothing)
{
    Graph graph;
    Texture t[3];
    for (int i = 0; i < 3; ++i) t[i] = graph.texture("t" + std::to_string(i), kFormat, {4, 4});
    graph.fullscreen("0", "").write(t[0]);
    graph.fullscreen("1", "").read(t[0]).write(t[1]);
    graph.fullscreen("2", "").read(t[1]).write(t[2]);
    graph.output(t[2]);
    const Schedule schedule = compile(graph);
    ASSERT_EQ(schedule.physicalOf[t[2].index], schedule.physicalOf[t[0].index]);
    const Barrier& moved = schedule.passes[2].barriers[1];
    EXPECT_EQ(moved.before.layout, VK_IMAGE_LAYOUT_UNDEFINED);
    EXPECT_TRUE(moved.before.stages & VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT) << "pass 1 still samples it";
}

TEST(Barriers, DepthTestedAndSampledAtOnceIsReadOnly)
{
    Graph graph;
    const Texture depth = graph.texture("depth", VK_FORMAT_D32_SFLOAT, {4, 4}), a = graph.texture("a", kFormat, {4, 4});
    graph.raster("prepass", "").write(depth);
    graph.raster("soft particles", "").read(depth).test(depth).write(a);
    graph.output(a);
    const Schedule schedule = compile(graph);
    const Barrier& both = schedule.passes[1].barriers[0];
    EXPECT_EQ(both.after.layout, VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL);
    EXPECT_TRUE(both.after.access & VK_ACCESS_2_SHADER_SAMPLED_READ_BIT);
    EXPECT_TRUE(both.after.access & VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT);
}

TEST(Barriers, RestingImagesThatAreOnlySampledNeedNone)
{
    GpuImage lightmap;
    lightmap.name = "lightmap";
    lightmap.shape = {kFormat, {4, 4, 1}};
    Graph graph;
    const Texture a = graph.texture("a", kFormat, {4, 4});
    graph.fullscreen("a", "").read(graph.import(lightmap)).write(a);
    graph.output(a);
    const Schedule schedule = compile(graph);
    EXPECT_EQ(schedule.passes[0].barriers.size(), 1u); // a's own
    EXPECT_EQ(schedule.last.size(), 1u);
}

TEST(BarriersDeath, SamplingWhatIsDrawnToIsAProgrammersError)
{
    Graph graph;
    const Texture a = graph.texture("a", kFormat, {4, 4});
    graph.fullscreen("first", "").write(a);
    graph.fullscreen("loop", "").read(a).write(a);
    graph.output(a);
    EXPECT_DEATH(compile(graph), "loop samples the texels that it draws to");
}

TEST(BarriersDeath, APartThatNothingWroteCannotBeRead)
{
    Graph graph;
    const Texture mips = graph.texture("mips", {kFormat, {4, 4, 1}, 2}), a = graph.texture("a", kFormat, {4, 4});
    graph.fullscreen("mip 0 only", "").write(mips.mip(0));
    graph.fullscreen("all mips", "").read(mips).write(a);
    graph.output(a);
    EXPECT_DEATH(compile(graph), "reads a part of mips that nothing wrote");
}
}
