// Frames run for real: chains, compute, buffers, histories, and what a mistake says.
#include "engine/core/error.hpp"
#include "tests/engine/graph/running.hpp"
#include <cstring>

namespace afterglow
{
using ExecutorTest = Running;

TEST_F(ExecutorTest, FullScreenStartsAtTheTopLeft)
{
    Graph graph;
    const Texture image = graph.texture("image", kFloat, {8, 4});
    graph.fullscreen("coordinates", kShaders + "coordinates.frag").write(image);
    graph.output(image);
    const FrameStats stats = executor.run(graph);
    const Image result = executor.download(image);
    // Pixel centres: uv = (x + 0.5) / width, gl_FragCoord = x + 0.5.
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 8; ++x) {
            EXPECT_NEAR(result.at(x, y)[0], (static_cast<float>(x) + 0.5f) / 8, 1e-6f);
            EXPECT_NEAR(result.at(x, y)[1], (static_cast<float>(y) + 0.5f) / 4, 1e-6f);
            EXPECT_EQ(result.at(x, y)[2], static_cast<float>(x) + 0.5f);
            EXPECT_EQ(result.at(x, y)[3], static_cast<float>(y) + 0.5f);
        }
    ASSERT_EQ(stats.passes.size(), 1u);
    EXPECT_GT(stats.passes[0].milliseconds, 0.0);
    EXPECT_EQ(stats.triangles, 1u);
    EXPECT_EQ(stats.passes[0].bytes, 8u * 4 * 16);
}

TEST_F(ExecutorTest, ComputeFeedsFragmentsAndConstantsSpecialize)
{
    // 13 x 7: no multiple of the work group; the dispatch covers it. Texel (x, y) = ((x + y) odd) * 3 + 0.5, twice.
    Graph graph;
    const Texture a = graph.texture("a", kFloat, {13, 7}), b = graph.texture("b", kFloat, {13, 7}), c = graph.texture("c", kFloat, {13, 7});
    graph.compute("checker", kShaders + "checker.comp").write(a).dispatch(a.size());
    graph.fullscreen("times 3 + 0.5", kShaders + "scale.frag").read(a).write(b).push(3.0f).specialize(0, 0.5f);
    graph.fullscreen("times 2", kShaders + "scale.frag").read(b).write(c).push(2.0f);
    graph.output(c);
    EXPECT_EQ(executor.run(graph).pipelines, 3u); // one shader, two constants
    const Image result = executor.download(c);
    for (int y = 0; y < 7; ++y)
        for (int x = 0; x < 13; ++x) EXPECT_EQ(result.at(x, y)[0], (x + y) % 2 ? 7.0f : 1.0f);
}

TEST_F(ExecutorTest, BuffersAreFilledModifiedAndReadBack)
{
    struct Item {
        glm::vec3 a;
        float b;
    };
    const std::vector<Item> items = {{{}, 3}, {{}, 41}, {{}, 7}};
    Graph graph;
    const Texture checker = graph.texture("checker", kFloat, {16, 16});
    const Buffer list = graph.upload("list", std::span<const Item>(items));
    const Buffer sum = graph.buffer("sum", 8);
    graph.compute("checker", kShaders + "checker.comp").write(checker).dispatch(checker.size());
    graph.fill("zero", sum, 0);
    graph.compute("sum", kShaders + "sum.comp").read(checker).read(list).modify(sum).dispatch(checker.size());
    graph.output(sum);
    executor.run(graph);
    std::uint32_t result[2];
    std::memcpy(result, executor.download(sum).data(), 8);
    EXPECT_EQ(result[0], 128u); // half of 256
    EXPECT_EQ(result[1], 41u);
}

TEST_F(ExecutorTest, CulledPassesCostNothing)
{
    Graph lean, rich;
    for (Graph* graph : {&lean, &rich}) {
        const Texture image = graph->texture("image", kFloat, {8, 8});
        graph->fullscreen("coordinates", kShaders + "coordinates.frag").write(image);
        graph->output(image);
        if (graph == &lean) continue;
        const Texture unread = graph->texture("unread", kFloat, {512, 512});
        graph->fullscreen("unread", "no/such/shader.frag").read(image).write(unread);
    }
    const FrameStats with = executor.run(rich), without = executor.run(lean);
    EXPECT_EQ(with.culled, std::vector<std::string>{"unread"});
    EXPECT_EQ(with.passes.size(), without.passes.size());
    EXPECT_EQ(with.pipelines, without.pipelines);
    EXPECT_EQ(with.gpuBytes, without.gpuBytes);
}

TEST_F(ExecutorTest, AnEmptyHandleBindsNothing)
{
    Graph graph;
    const Texture a = graph.texture("a", kFloat, {4, 4}), b = graph.texture("b", kFloat, {4, 4});
    graph.fullscreen("coordinates", kShaders + "coordinates.frag").write(a);
    graph.fullscreen("either", kShaders + "either.frag").read(Texture{}).read(a).write(b).specialize(0, false);
    graph.output(b);
    executor.run(graph);
    EXPECT_EQ(executor.download(b).at(3, 0)[2], 3.5f);
}

TEST_F(ExecutorTest, MipsAreDrawnAndSampledOneByOne)
{
    Graph graph;
    const Texture chain = graph.texture("chain", {kFloat, {8, 8, 1}, 3});
    graph.compute("checker", kShaders + "checker.comp").write(chain.mip(0)).dispatch(chain.size());
    for (std::uint32_t mip = 1; mip < 3; ++mip)
        graph.fullscreen("mip " + std::to_string(mip), kShaders + "sample.frag")
            .read(chain.mip(mip - 1), Sampler::linear)
            .write(chain.mip(mip));
    graph.output(chain);
    executor.run(graph);
    // Each texel lies between four of the checker: two of them are 1.
    for (const float value : executor.download(chain.mip(2)).pixels) EXPECT_NEAR(value, 0.5f, 1e-6f);
}

TEST_F(ExecutorTest, CopiesScaleAndImportsRest)
{
    const GpuImage outside = gpu.memory.image("outside", {kFloat, {4, 4, 1}}, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
    Graph graph;
    const Texture large = graph.texture("large", kFloat, {8, 8});
    graph.fullscreen("coordinates", kShaders + "coordinates.frag").write(large);
    graph.copy("halve", large, graph.import(outside));
    executor.run(graph);
    Graph next;
    const Texture twice = next.texture("twice", kFloat, {4, 4});
    next.fullscreen("twice", kShaders + "scale.frag").read(next.import(outside)).write(twice).push(2.0f);
    next.output(twice);
    executor.run(next);
    EXPECT_NEAR(executor.download(twice).at(1, 0)[2], 2 * 3.0f, 1e-4f); // halfway between 2.5 and 3.5
}

TEST_F(ExecutorTest, APassThatDoesNotFitItsShaderIsASentence)
{
    const auto sentence = [&](auto declare) -> std::string {
        Graph graph;
        const Texture a = graph.texture("a", kFloat, {4, 4}), b = graph.texture("b", kFloat, {4, 4});
        graph.fullscreen("coordinates", kShaders + "coordinates.frag").write(a);
        declare(graph, a, b);
        graph.output(b);
        try {
            executor.run(graph);
        } catch (const Error& error) {
            return error.what();
        }
        return "it ran";
    };
    const std::string scale = kShaders + "scale.frag";
    EXPECT_NE(sentence([&](Graph& g, Texture, Texture b) { g.fullscreen("scale", scale).write(b).push(1.0f); }).find("binding 0"),
              std::string::npos);
    EXPECT_NE(sentence([&](Graph& g, Texture a, Texture b) {
                  g.fullscreen("scale", scale).read(a).read(a).write(b).push(1.0f);
              }).find("binding 1"),
              std::string::npos);
    EXPECT_NE(sentence([&](Graph& g, Texture, Texture b) {
                  g.fullscreen("scale", scale).read(g.upload("number", 1.0f)).write(b).push(1.0f);
              }).find("not of the kind"),
              std::string::npos);
}
}
