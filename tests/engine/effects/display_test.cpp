// From radiance to what a screen shows: given exposure, measured exposure, and what must stay black.
#include "engine/effects/display/display.h"
#include "engine/gpu/readback.hpp"
#include "tests/engine/effects/drawn.hpp"

namespace afterglow
{
class DisplayTest : public Validated
{
protected:
    // A picture of one radiance, displayed; its first pixel.
    uvec3 shown(vec3 radiance, const DisplayParameters& parameters, uvec2 size = {40, 30})
    {
        GpuImage picture = gpu.memory.image("picture", {.format = VK_FORMAT_R32G32B32A32_SFLOAT, .size = {size, 1}});
        const std::vector<vec4> texels(std::size_t(size.x) * size.y, vec4(radiance, 1.0f));
        gpu.memory.upload(picture, texels.data(), texels.size() * sizeof(vec4));
        Executor executor(gpu);
        Graph graph;
        const Texture displayed = display(graph, graph.import(picture), parameters);
        graph.output(displayed);
        stats = executor.run(graph);
        const Image8 result = readback8(gpu.memory, executor.image(displayed));
        return uvec3(result.pixels[0], result.pixels[1], result.pixels[2]);
    }
    FrameStats stats;
};

TEST_F(DisplayTest, AGivenExposureIsTheLawOfTheCurve)
{
    for (const ToneCurve curve : {ToneCurve::none, ToneCurve::reinhard, ToneCurve::aces, ToneCurve::hable}) {
        const uint law = curve == ToneCurve::none       ? kToneNone
                         : curve == ToneCurve::reinhard ? kToneReinhard
                         : curve == ToneCurve::aces     ? kToneAces
                                                        : kToneHable;
        const vec3 radiance(0.1f, 0.5f, 3.0f);
        const vec3 wanted = 255.0f * srgbEncode(toneMap(radiance * exposureFromEv(1.5f), law));
        const uvec3 got = shown(radiance, {.exposureEv = 1.5f, .curve = curve});
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(float(got[c]), wanted[c], 0.6f) << int(curve) << ' ' << c;
        EXPECT_EQ(stats.passes.size(), 1u) << "nothing is measured when the exposure is given";
    }
}

TEST_F(DisplayTest, AnEvenPictureIsShownAsMiddleGreyHoweverBright)
{
    const float grey = 255.0f * srgbEncode(0.18f);
    for (const float radiance : {0.002f, 1.0f, 900.0f})
        EXPECT_NEAR(float(shown(vec3(radiance), {.curve = ToneCurve::none}).x), grey, 1.0f) << radiance;
}

// H37, H78: black stays black, and what is not a number is shown as black too.
TEST_F(DisplayTest, BlackAndNanAreBlack)
{
    EXPECT_EQ(shown(vec3(0.0f), {}), uvec3(0));
    EXPECT_EQ(shown(vec3(std::numeric_limits<float>::quiet_NaN()), {}), uvec3(0));
    EXPECT_EQ(shown(vec3(-1.0f), {.exposureEv = 0.0f}), uvec3(0));
}

TEST_F(DisplayTest, InfinityIsWhiteAndAPictureMayBeOnePixel)
{
    EXPECT_EQ(shown(vec3(INFINITY), {.exposureEv = 0.0f}), uvec3(255));
    EXPECT_NEAR(float(shown(vec3(5.0f), {.curve = ToneCurve::none}, {1, 1}).x), 255.0f * srgbEncode(0.18f), 1.0f);
}
}
