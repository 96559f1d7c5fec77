// Culling, without a GPU: a pass lives exactly if an output depends on it.
#include "engine/graph/schedule.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
static const VkFormat kFormat = VK_FORMAT_R8G8B8A8_UNORM;

static std::vector<std::string> names(const Graph& graph)
{
    std::vector<std::string> result;
    for (const ScheduledPass& pass : compile(graph).passes) result.push_back(graph.passes[pass.pass].name);
    return result;
}

using Names = std::vector<std::string>;

TEST(Live, WhatNoOutputDependsOnIsCulledWithItsInputs)
{
    Graph graph;
    const Texture a = graph.texture("a", kFormat, {4, 4}), b = graph.texture("b", kFormat, {4, 4}), c = graph.texture("c", kFormat, {4, 4});
    graph.fullscreen("makes a", "").write(a);
    graph.fullscreen("makes b", "").write(b);
    graph.fullscreen("b to c, which nobody reads", "").read(b).write(c);
    graph.output(a);
    EXPECT_EQ(names(graph), Names{"makes a"});
    EXPECT_EQ(compile(graph).culled, (Names{"makes b", "b to c, which nobody reads"}));
    EXPECT_EQ(compile(graph).physicalOf[b.index], kNoResource);
}

TEST(Live, ADisplayChainLivesAsAWhole)
{
    Graph graph;
    const Texture a = graph.texture("a", kFormat, {4, 4}), b = graph.texture("b", kFormat, {4, 4});
    graph.fullscreen("first", "").write(a);
    graph.fullscreen("second", "").read(a).write(b);
    graph.output(b);
    EXPECT_EQ(names(graph), (Names{"first", "second"}));
}

TEST(Live, AnOverwrittenVersionIsCulledAModifiedOneIsNot)
{
    Graph graph;
    const Texture a = graph.texture("a", kFormat, {4, 4});
    graph.fullscreen("overwritten", "").write(a);
    graph.fullscreen("kept", "").write(a);
    graph.fullscreen("on top", "").modify(a);
    graph.output(a);
    EXPECT_EQ(names(graph), (Names{"kept", "on top"}));
}

TEST(Live, AReaderSeesTheVersionOfItsTime)
{
    Graph graph;
    const Texture a = graph.texture("a", kFormat, {4, 4}), b = graph.texture("b", kFormat, {4, 4});
    graph.fullscreen("first a", "").write(a);
    graph.fullscreen("reader", "").read(a).write(b);
    graph.fullscreen("second a, unread", "").write(a);
    graph.output(b);
    EXPECT_EQ(names(graph), (Names{"first a", "reader"}));
}

TEST(Live, EveryLayerOfAWholeLives)
{
    Graph graph;
    const Texture cascades = graph.texture("cascades", {VK_FORMAT_D32_SFLOAT, {8, 8, 1}, 1, 3, ImageKind::array});
    const Texture picture = graph.texture("picture", kFormat, {4, 4});
    for (std::uint32_t i = 0; i < 3; ++i) graph.raster("cascade " + std::to_string(i), "").write(cascades.layer(i));
    graph.fullscreen("lit", "").read(cascades, Sampler::shadow).write(picture);
    graph.output(picture);
    EXPECT_EQ(names(graph).size(), 4u);
}

TEST(Live, WritingWhatLivesOutsideIsAnEffectOfItsOwn)
{
    const GpuImage outside = [] {
        GpuImage image;
        image.name = "outside";
        image.shape = {kFormat, {4, 4, 1}};
        return image;
    }();
    Graph graph;
    graph.fullscreen("fills", "").write(graph.import(outside));
    EXPECT_EQ(names(graph), Names{"fills"});
}

TEST(Live, AHistoryLivesWhenItsPastIsRead)
{
    Graph graph;
    const History history = graph.history("ao", kFormat, {4, 4});
    const Texture now = graph.texture("now", kFormat, {4, 4}), picture = graph.texture("picture", kFormat, {4, 4});
    graph.fullscreen("blend", "").read(history.previous).write(now);
    graph.fullscreen("remember", "").read(now).write(history.current); // only the next frame reads it
    graph.fullscreen("show", "").read(now).write(picture);
    graph.output(picture);
    EXPECT_EQ(names(graph), (Names{"blend", "remember", "show"}));

    Graph other;
    const History unread = other.history("ao", kFormat, {4, 4});
    other.fullscreen("blend", "").read(unread.previous).write(unread.current);
    EXPECT_EQ(names(other), Names{});
}

TEST(Live, AnEmptyHandleKeepsItsBinding)
{
    Graph graph;
    const Texture a = graph.texture("a", kFormat, {4, 4});
    graph.fullscreen("reads nothing", "").read(Texture{}).write(a);
    graph.output(a);
    EXPECT_EQ(names(graph), Names{"reads nothing"});
}

TEST(LiveDeath, ReadingWhatNothingWroteIsAProgrammersError)
{
    Graph graph;
    const Texture a = graph.texture("a", kFormat, {4, 4}), b = graph.texture("b", kFormat, {4, 4});
    graph.fullscreen("early", "").read(a).write(b);
    graph.output(b);
    EXPECT_DEATH(compile(graph), "early reads a, which nothing wrote");
}
}
