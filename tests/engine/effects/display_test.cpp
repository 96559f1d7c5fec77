// From radiance to what a screen shows: given exposure, measured exposure, and what must stay black.
#include "engine/effects/display/display.h"
#include "engine/gpu/readback.hpp"
#include "tests/engine/effects/drawn.hpp"
#include <cstdio>
#include <tuple>

namespace afterglow
{
class DisplayTest : public Validated
{
protected:
    // A picture of one radiance, displayed; its first pixel.
    uvec3 shown(vec3 radiance, const DisplayParameters& parameters, uvec2 size = {40, 30})
    {
        return shown(std::vector<vec4>(std::size_t(size.x) * size.y, vec4(radiance, 1.0f)), parameters, size);
    }
    uvec3 shown(const std::vector<vec4>& texels, const DisplayParameters& parameters, uvec2 size)
    {
        GpuImage picture = gpu.memory.image("picture", {.format = VK_FORMAT_R32G32B32A32_SFLOAT, .size = {size, 1}});
        gpu.memory.upload(picture, texels.data(), texels.size() * sizeof(vec4));
        Graph graph;
        const Texture displayed = display(graph, graph.import(picture), parameters);
        graph.output(displayed);
        stats = executor.run(graph);
        const Image8 result = readback8(gpu.memory, executor.image(displayed));
        return uvec3(result.pixels[0], result.pixels[1], result.pixels[2]);
    }
    // EV by which the picture is brightened so that its mean is middle grey, by what its first pixel, of a known luminance, becomes.
    double measuredEv(const std::vector<vec4>& texels, uvec2 size)
    {
        const float code = float(shown(texels, {.curve = ToneCurve::none}, size).x) / 255.0f;
        return std::log2(double(srgbDecode(code)) / double(texels[0].x));
    }
    FrameStats stats;
    Executor executor{gpu};
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

// The eye adapts over frames, evenly in EV; a picture by itself is exposed at once.
TEST_F(DisplayTest, AdaptsFromTheLastFramesExposure)
{
    const DisplayParameters half{.curve = ToneCurve::none, .adapt = 0.5f};
    const auto code = [](float display) { return 255.0f * srgbEncode(display); };
    EXPECT_NEAR(float(shown(vec3(0.5f), half).x), code(0.18f), 1.0f) << "nothing was seen before";
    EXPECT_NEAR(float(shown(vec3(2.0f), half).x), code(0.36f), 1.0f) << "2 EV brighter, of which one is left";
    EXPECT_NEAR(float(shown(vec3(2.0f), half).x), code(0.18f * std::sqrt(2.0f)), 1.0f);
    EXPECT_NEAR(float(shown(vec3(2.0f), {.curve = ToneCurve::none}).x), code(0.18f), 1.0f);
    EXPECT_NEAR(float(shown(vec3(0.0f), half).x), 0.0f, 0.0f);
    EXPECT_NEAR(float(shown(vec3(0.18f), {.curve = ToneCurve::none, .adapt = 0.99f}).x), code(0.18f), 1.0f) << "black was finite";
}

// A wall whose luminance varies by 2 EV, and something small and extreme before it: how far does it move the exposure? Against the mean of
// log luminance, derived here, which it moves by its share of the picture times its distance in EV.
TEST_F(DisplayTest, IsMovedLittleByWhatIsSmallAndExtreme)
{
    const uvec2 size(256, 144);
    std::vector<vec4> wall(size.x * size.y);
    for (std::size_t i = 0; i < wall.size(); ++i)
        wall[i] = vec4(vec3(std::exp2(2.0f * float((i * 7919) % wall.size()) / float(wall.size()) - 1.0f)), 1);
    wall[0] = vec4(1.0f);
    const double plain = measuredEv(wall, size);
    EXPECT_NEAR(plain, std::log2(0.18), 0.02) << "without extremes it is the mean of log luminance";
    std::printf("| what stands before the wall | share | plain mean moves by | histogram moves by |\n|---|---|---|---|\n");
    for (const auto& [what, ev, share] :
         {std::tuple("lamp", 10.0f, 0.02), {"lamp", 10.0f, 0.08}, {"shade", -8.0f, 0.02}, {"shade", -8.0f, 0.08}}) {
        std::vector<vec4> picture = wall;
        const std::size_t first = picture.size() / 3, count = std::size_t(share * double(picture.size()));
        double moved = 0;
        for (std::size_t i = first; i < first + count; ++i) {
            moved -= (double(ev) - std::log2(double(wall[i].x))) / double(picture.size());
            picture[i] = vec4(vec3(std::exp2(ev)), 1);
        }
        const double histogram = measuredEv(picture, size) - plain;
        std::printf("| %s, %+.0f EV | %.0f %% | %+.2f EV | %+.2f EV |\n", what, double(ev), 100.0 * share, moved, histogram);
        EXPECT_LT(std::abs(histogram), 0.35 * std::abs(moved)) << what << share;
    }
}
}
