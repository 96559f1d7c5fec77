// A smaller picture brought to size: what is even or straight stays so, no halo at an edge, identity at the same size.
#include "engine/effects/upscale/upscale.hpp"
#include "engine/graph/executor.hpp"
#include "tests/engine/gpu/validated.hpp"
#include <functional>

namespace afterglow
{
class Upscale : public Validated
{
protected:
    Image upscaled(uvec2 drawn, uvec2 shown, const std::function<float(vec2)>& at)
    {
        std::vector<vec4> texels;
        for (uint y = 0; y < drawn.y; ++y)
            for (uint x = 0; x < drawn.x; ++x) texels.push_back(vec4(vec3(at((vec2(x, y) + 0.5f) / vec2(drawn))), 1.0f));
        GpuImage picture = gpu.memory.image("picture", {.format = VK_FORMAT_R32G32B32A32_SFLOAT, .size = {drawn, 1}});
        gpu.memory.upload(picture, texels.data(), texels.size() * sizeof(vec4));
        Executor executor(gpu);
        Graph graph;
        const Texture result = upscale(graph, View{}, graph.import(picture), shown);
        graph.output(result);
        executor.run(graph);
        return executor.download(result);
    }
};

TEST_F(Upscale, KeepsAStraightRampStraight)
{
    const auto ramp = [](vec2 uv) { return 3.0f * uv.x + 2.0f * uv.y; };
    const uvec2 shown(40, 25);
    const Image result = upscaled({20, 15}, shown, ramp);
    for (int y = 4; y < 21; ++y)
        for (int x = 4; x < 36; ++x) EXPECT_NEAR(*result.at(x, y), ramp((vec2(x, y) + 0.5f) / vec2(shown)), 1e-4f);
}

TEST_F(Upscale, GivesAnEdgeNoHalo)
{
    const Image result = upscaled({16, 16}, {50, 37}, [](vec2 uv) { return uv.x + 0.3f * uv.y < 0.6f ? 0.1f : 900.0f; });
    for (std::size_t i = 0; i < result.pixels.size(); i += 4) EXPECT_TRUE(result.pixels[i] >= 0.1f && result.pixels[i] <= 900.0f);
}

// H72, and forced on without a scale.
TEST_F(Upscale, OfTheSameSizeChangesNothing)
{
    const auto hard = [](vec2 uv) { return std::fmod(17.0f * uv.x + 31.0f * uv.y, 1.0f); };
    for (const uvec2 size : {uvec2(1, 1), uvec2(1, 9), uvec2(13, 7)}) {
        const Image result = upscaled(size, size, hard);
        for (int y = 0; y < int(size.y); ++y)
            for (int x = 0; x < int(size.x); ++x) EXPECT_NEAR(*result.at(x, y), hard((vec2(x, y) + 0.5f) / vec2(size)), 1e-5f);
    }
}
}
