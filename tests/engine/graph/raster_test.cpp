// Triangles: reversed depth, clears, culling, bias, blending, shadow comparison, layers.
#include "engine/graph/draw.hpp"
#include "engine/graph/executor.hpp"
#include "tests/engine/gpu/validated.hpp"

namespace afterglow
{
static const VkFormat kFloat = VK_FORMAT_R32G32B32A32_SFLOAT;
static const VkFormat kDepth = VK_FORMAT_D32_SFLOAT;
static const std::string kShaders = "tests/engine/graph/shaders/";

class RasterTest : public Validated
{
protected:
    // A triangle that covers all of the picture at one depth, counter-clockwise as seen.
    static void cover(std::vector<glm::vec3>& vertices, float depth)
    {
        vertices.insert(vertices.end(), {{-1, -1, depth}, {-1, 3, depth}, {3, -1, depth}});
    }
    static Pass draws(Graph& graph, const std::vector<glm::vec3>& vertices)
    {
        const auto count = static_cast<std::uint32_t>(vertices.size());
        Pass pass = graph.raster("draw", kShaders + "triangles.vert", kShaders + "number.frag");
        pass.read(graph.upload("vertices", std::span<const glm::vec3>(vertices)))
            .draw([count](Draw& draw) { draw.vertices(count); })
            .push(1.0f);
        return pass;
    }
    Executor executor{gpu};
};

TEST_F(RasterTest, TheGreaterDepthIsNearerAndWinsInAnyOrder)
{
    for (const bool nearFirst : {true, false}) {
        Graph graph;
        const Texture color = graph.texture("color", kFloat, {8, 8}), depth = graph.texture("depth", kDepth, {8, 8});
        std::vector<glm::vec3> vertices;
        cover(vertices, nearFirst ? 0.75f : 0.25f);
        cover(vertices, nearFirst ? 0.25f : 0.75f);
        draws(graph, vertices).write(color).write(depth);
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
    draws(graph, {{-1, -1, 0.5f}, {-1, 1, 0.5f}, {1, -1, 0.5f}}).write(color, {5, 6, 7, 8}).write(depth);
    graph.output(color);
    graph.output(depth);
    executor.run(graph);
    const Image result = executor.download(color);
    EXPECT_EQ(result.at(0, 0)[0], 1.0f);
    EXPECT_EQ(result.at(7, 7)[1], 6.0f);
    EXPECT_EQ(executor.download(depth).at(7, 7)[0], 0.0f); // infinitely far
}

TEST_F(RasterTest, BackFacesAreCulledAndMirroringTurnsThem)
{
    for (const bool mirrored : {false, true}) {
        Graph graph;
        const Texture color = graph.texture("color", kFloat, {4, 4});
        std::vector<glm::vec3> vertices;
        cover(vertices, 0.5f);
        const Buffer list = graph.upload("vertices", std::span<const glm::vec3>(vertices));
        graph.raster("draw", kShaders + "triangles.vert", kShaders + "number.frag")
            .read(list)
            .write(color)
            .cull(Cull::back)
            .push(1.0f)
            .draw([mirrored](Draw& draw) {
                draw.mirrored(mirrored);
                draw.vertices(3);
            });
        graph.output(color);
        executor.run(graph);
        EXPECT_EQ(executor.download(color).at(1, 1)[0], mirrored ? 0.0f : 1.0f);
    }
}

TEST_F(RasterTest, PushConstantsChangeBetweenDraws)
{
    Graph graph;
    const Texture color = graph.texture("color", kFloat, {4, 4});
    std::vector<glm::vec3> vertices;
    cover(vertices, 0.5f);
    const Buffer list = graph.upload("vertices", std::span<const glm::vec3>(vertices));
    graph.raster("draw", kShaders + "triangles.vert", kShaders + "number.frag")
        .read(list)
        .write(color)
        .blend(Blend::add)
        .draw([](Draw& draw) {
            for (const float factor : {1.0f, 10.0f, 100.0f}) {
                draw.push(factor);
                draw.vertices(3);
            }
        });
    graph.output(color);
    EXPECT_EQ(executor.run(graph).draws, 3u);
    EXPECT_EQ(executor.download(color).at(1, 1)[0], 111.0f);
}

TEST_F(RasterTest, APrepassIsTestedAndNotWritten)
{
    Graph graph;
    const Texture color = graph.texture("color", kFloat, {4, 4}), depth = graph.texture("depth", kDepth, {4, 4});
    std::vector<glm::vec3> occluder, two;
    cover(occluder, 0.5f);
    cover(two, 0.25f); // behind
    cover(two, 0.5f);  // equal
    const Buffer list = graph.upload("occluder", std::span<const glm::vec3>(occluder));
    graph.raster("prepass", kShaders + "triangles.vert").read(list).write(depth).draw([](Draw& draw) { draw.vertices(3); });
    draws(graph, two).write(color).test(depth).compare(Compare::equal);
    graph.output(color);
    graph.output(depth);
    executor.run(graph);
    EXPECT_EQ(executor.download(color).at(1, 1)[0], 2.0f);
    EXPECT_EQ(executor.download(depth).at(1, 1)[0], 0.5f);
}

TEST_F(RasterTest, ShadowComparisonLightsWhatIsNotBehind)
{
    for (const float reference : {0.4f, 0.6f}) {
        Graph graph;
        const Texture map = graph.texture("map", {kDepth, {8, 8, 1}, 1, 2, ImageKind::array}), lit = graph.texture("lit", kFloat, {4, 4});
        std::vector<glm::vec3> vertices;
        cover(vertices, 0.5f);
        const Buffer list = graph.upload("vertices", std::span<const glm::vec3>(vertices));
        graph.raster("map", kShaders + "triangles.vert").read(list).write(map.layer(1)).draw([](Draw& draw) { draw.vertices(3); });
        graph.fullscreen("lit", kShaders + "shadow.frag").read(map.layer(1), Sampler::shadow).write(lit).push(reference);
        graph.output(lit);
        executor.run(graph);
        EXPECT_EQ(executor.download(lit).at(2, 2)[0], reference > 0.5f ? 1.0f : 0.0f); // nearer than the occluder: lit
    }
}

TEST_F(RasterTest, AreaLimitsAndModifyKeepsTheRest)
{
    Graph graph;
    const Texture color = graph.texture("color", kFloat, {8, 8});
    std::vector<glm::vec3> vertices;
    cover(vertices, 0.5f);
    draws(graph, vertices).write(color);
    const Buffer list = graph.upload("again", std::span<const glm::vec3>(vertices));
    graph.raster("corner", kShaders + "triangles.vert", kShaders + "number.frag")
        .read(list)
        .modify(color)
        .area({4, 4, 4, 4})
        .push(9.0f)
        .draw([](Draw& draw) { draw.vertices(3); });
    graph.output(color);
    executor.run(graph);
    EXPECT_EQ(executor.download(color).at(3, 3)[0], 1.0f);
    EXPECT_EQ(executor.download(color).at(4, 4)[0], 9.0f);
}

TEST_F(RasterTest, BiasMovesDepthAwayFromTheViewer)
{
    Graph graph;
    const Texture depth = graph.texture("depth", kDepth, {4, 4});
    std::vector<glm::vec3> vertices;
    cover(vertices, 0.5f);
    const Buffer list = graph.upload("vertices", std::span<const glm::vec3>(vertices));
    graph.raster("biased", kShaders + "triangles.vert").read(list).write(depth).bias(-1000, 0).draw([](Draw& draw) { draw.vertices(3); });
    graph.output(depth);
    executor.run(graph);
    EXPECT_LT(executor.download(depth).at(1, 1)[0], 0.5f);
    EXPECT_GT(executor.download(depth).at(1, 1)[0], 0.49f);
}
}
