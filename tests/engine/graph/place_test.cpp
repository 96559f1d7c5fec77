// Places, without a GPU: who shares an image with whom, and what each may be used for.
#include "engine/graph/schedule.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
static const VkFormat kFormat = VK_FORMAT_R16G16B16A16_SFLOAT;

// A chain of n full-screen passes, each reading the one before.
static Graph chain(int n)
{
    Graph graph;
    Texture last;
    for (int i = 0; i < n; ++i) {
        const Texture next = graph.texture("t" + std::to_string(i), kFormat, {8, 8});
        Pass pass = graph.fullscreen("p" + std::to_string(i), "");
        if (last) pass.read(last);
        pass.write(next);
        last = next;
    }
    graph.output(last);
    return graph;
}

TEST(Place, ALongChainNeedsTwoImages)
{
    // Reader and writer live at once; the one before is free again.
    EXPECT_EQ(compile(chain(7)).physicals.size(), 2u);
}

TEST(Place, OverlappingLivesDoNotShare)
{
    Graph graph;
    const Texture a = graph.texture("a", kFormat, {8, 8}), b = graph.texture("b", kFormat, {8, 8}), c = graph.texture("c", kFormat, {8, 8});
    graph.fullscreen("a", "").write(a);
    graph.fullscreen("b", "").read(a).write(b);
    graph.fullscreen("c", "").read(a).read(b).write(c);
    graph.output(c);
    EXPECT_EQ(compile(graph).physicals.size(), 3u);
}

TEST(Place, OtherShapesDoNotShare)
{
    Graph graph;
    const Texture a = graph.texture("a", kFormat, {8, 8}), b = graph.texture("b", kFormat, {4, 4}),
                  c = graph.texture("c", kFormat, {16, 16});
    graph.fullscreen("a", "").write(a);
    graph.fullscreen("b", "").read(a).write(b);
    graph.fullscreen("c", "").read(b).write(c);
    graph.output(c);
    EXPECT_EQ(compile(graph).physicals.size(), 3u);
}

TEST(Place, OutputsKeepTheirImageToTheEnd)
{
    Graph graph = chain(4);
    graph.output(Texture{0, {kFormat, {8, 8, 1}}});
    const Schedule schedule = compile(graph);
    for (std::uint32_t r = 1; r < 4; ++r) EXPECT_NE(schedule.physicalOf[r], schedule.physicalOf[0]);
}

TEST(Place, UsageIsWhatAllTenantsNeed)
{
    Graph graph;
    const Texture a = graph.texture("a", kFormat, {8, 8}), b = graph.texture("b", kFormat, {8, 8}), c = graph.texture("c", kFormat, {8, 8});
    graph.compute("a", "").write(a).dispatch(glm::uvec2(8));
    graph.fullscreen("b", "").read(a).write(b);
    graph.fullscreen("c", "").read(b).write(c);
    graph.output(c);
    const Schedule schedule = compile(graph);
    ASSERT_EQ(schedule.physicalOf[a.index], schedule.physicalOf[c.index]);
    EXPECT_EQ(schedule.physicals[schedule.physicalOf[a.index]].imageUsage,
              static_cast<VkImageUsageFlags>(VK_IMAGE_USAGE_STORAGE_BIT) | VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
    EXPECT_EQ(schedule.physicals[schedule.physicalOf[b.index]].imageUsage,
              static_cast<VkImageUsageFlags>(VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT));
}
}
