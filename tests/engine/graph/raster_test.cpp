// Triangles: reversed depth, clears, bias, areas, shadow comparison, layers.
#include "engine/graph/draw.hpp"
#include "tests/engine/graph/running.hpp"

namespace afterglow
{
class RasterTest : public Running
{
protected:
    // Triangles that cover all of the picture, one at each depth, counter-clockwise as seen.
    static Buffer covers(Graph& graph, const std::vector<float>& depths)
    {
        std::vector<glm::vec3> vertices;
        for (const float depth : depths) vertices.insert(vertices.end(), {{-1, -1, depth}, {-1, 3, depth}, {3, -1, depth}});
        return graph.upload("vertices", std::span<const glm::vec3>(vertices));
    }
    // A pass that draws so many triangles; each shows the number of its first vertex over 3, and 1.
    static Pass draws(Graph& graph, const Buffer& vertices, const std::string& fragmentShader = kShaders + "number.frag")
    {
        const auto count = static_cast<std::uint32_t>(vertices.bytes / sizeof(glm::vec3));
        Pass pass = graph.raster("draw", kShaders + "triangles.vert", fragmentShader);
        pass.read(vertices).draw([count](Draw& draw) { draw.vertices(count); });
        if (!fragmentShader.empty()) pass.push(1.0f);
        return pass;
    }
    // Without a fragment shader: depth alone.
    static Pass drawsDepth(Graph& graph, const Buffer& vertices) { return draws(graph, vertices, ""); }
};

TEST_F(RasterTest, TheGreaterDepthIsNearerAndWinsInAnyOrder)
{
    for (const bool nearFirst : {true, false}) {
        Graph graph;
        const Texture color = graph.texture("color", kFloat, {8, 8}), depth = graph.texture("depth", kDepth, {8, 8});
        draws(graph, covers(graph, nearFirst ? std::vector{0.75f, 0.25f} : std::vector{0.25f, 0.75f})).write(color).write(depth);
        graph.output(color);
        graph.output(depth);
        const FrameStats stats = executor.run(graph);
        EXPECT_EQ(executor.download(color).at(3, 3)[0], nearFirst ? 1.0f : 2.0f);
        EXPECT_EQ(executor.download(depth).at(3, 3)[0], 0.75f);
        EXPECT_EQ(stats.draws, 1u);
        EXPECT_EQ(stats.triangles, 2u);
    }
}

TEST_F(RasterTest, WhereNothingIsDrawnTheClearStays)
{
    Graph graph;
    const Texture color = graph.texture("color", kFloat, {8, 8}), depth = graph.texture("depth", kDepth, {8, 8});
    // The upper left half: y grows downwards in clip space.
    const std::vector<glm::vec3> half = {{-1, -1, 0.5f}, {-1, 1, 0.5f}, {1, -1, 0.5f}};
    draws(graph, graph.upload("vertices", std::span<const glm::vec3>(half))).write(color, {5, 6, 7, 8}).write(depth);
    graph.output(color);
    graph.output(depth);
    executor.run(graph);
    const Image result = executor.download(color);
    EXPECT_EQ(result.at(0, 0)[0], 1.0f);
    EXPECT_EQ(result.at(7, 7)[1], 6.0f);
    EXPECT_EQ(executor.download(depth).at(7, 7)[0], 0.0f); // infinitely far
}

TEST_F(RasterTest, PushConstantsAndAreasChangeBetweenDraws)
{
    Graph graph;
    const Texture color = graph.texture("color", kFloat, {8, 8});
    draws(graph, covers(graph, {0.5f})).write(color).draw([](Draw& draw) {
        draw.vertices(3);
        draw.push(9.0f);
        draw.area({4, 4, 4, 4});
        draw.vertices(3);
    });
    graph.output(color);
    EXPECT_EQ(executor.run(graph).draws, 2u);
    EXPECT_EQ(executor.download(color).at(3, 3)[0], 1.0f);
    EXPECT_EQ(executor.download(color).at(4, 4)[0], 9.0f);
}

TEST_F(RasterTest, APrepassIsTestedAndNotWritten)
{
    Graph graph;
    const Texture color = graph.texture("color", kFloat, {4, 4}), depth = graph.texture("depth", kDepth, {4, 4});
    drawsDepth(graph, covers(graph, {0.5f})).write(depth);
    draws(graph, covers(graph, {0.75f, 0.5f, 0.25f})).write(color).test(depth); // before it, on it, behind it
    graph.output(color);
    graph.output(depth);
    executor.run(graph);
    EXPECT_EQ(executor.download(color).at(1, 1)[0], 2.0f); // the second is not hidden by the first
    EXPECT_EQ(executor.download(depth).at(1, 1)[0], 0.5f);
}

TEST_F(RasterTest, ModifyDrawsOnTopOfWhatIsThere)
{
    Graph graph;
    const Texture color = graph.texture("color", kFloat, {8, 8});
    draws(graph, covers(graph, {0.5f})).write(color);
    draws(graph, covers(graph, {0.5f})).modify(color).draw([](Draw& draw) {
        draw.push(9.0f);
        draw.area({4, 4, 4, 4});
        draw.vertices(3);
    });
    graph.output(color);
    executor.run(graph);
    EXPECT_EQ(executor.download(color).at(3, 3)[0], 1.0f);
    EXPECT_EQ(executor.download(color).at(4, 4)[0], 9.0f);
}

TEST_F(RasterTest, AnEmptyAttachmentKeepsItsNumber)
{
    Graph graph;
    const Texture color = graph.texture("color", kFloat, {4, 4});
    draws(graph, covers(graph, {0.5f}), kShaders + "pair.frag").write(Texture{}).write(color);
    graph.output(color);
    executor.run(graph);
    EXPECT_EQ(executor.download(color).at(1, 1)[0], 2.0f); // the second output
}

TEST_F(RasterTest, ShadowComparisonLightsWhatIsNotBehind)
{
    for (const float reference : {0.4f, 0.6f}) {
        Graph graph;
        const Texture map = graph.texture("map", {kDepth, {8, 8, 1}, 1, 2, ImageKind::array}), lit = graph.texture("lit", kFloat, {4, 4});
        drawsDepth(graph, covers(graph, {0.5f})).write(map.layer(1));
        graph.fullscreen("lit", kShaders + "shadow.frag").read(map.layer(1), Sampler::shadow).write(lit).push(reference);
        graph.output(lit);
        executor.run(graph);
        EXPECT_EQ(executor.download(lit).at(2, 2)[0], reference > 0.5f ? 1.0f : 0.0f); // nearer than the occluder: lit
    }
}

TEST_F(RasterTest, BiasMovesDepthAwayFromTheViewer)
{
    Graph graph;
    const Texture depth = graph.texture("depth", kDepth, {4, 4});
    drawsDepth(graph, covers(graph, {0.5f})).write(depth).bias(-1000, 0);
    graph.output(depth);
    executor.run(graph);
    EXPECT_LT(executor.download(depth).at(1, 1)[0], 0.5f);
    EXPECT_GT(executor.download(depth).at(1, 1)[0], 0.49f);
}
}
