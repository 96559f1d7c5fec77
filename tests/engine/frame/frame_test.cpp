// Whole frames: off costs nothing, forced on changes nothing, odd sizes and empty levels draw.
#include "tests/engine/frame/frame.hpp"

namespace afterglow
{
TEST_F(FrameTest, WhatIsOffHasNoPassAndNoMemory)
{
    draw(scene, nullptr, "auto");
    for (const char* pass : {"shadow", "reflection", "fog", "occlusion", "lighting.clear", "geometry.masked", "bloom", "toon", "outline"})
        EXPECT_FALSE(ran(pass)) << pass;
    draw(scene, nullptr, "-antialias");
    EXPECT_FALSE(ran("antialias"));
    const std::uint64_t automatic = stats.gpuBytes;
    draw(scene, nullptr, "none");
    EXPECT_EQ(stats.gpuBytes, automatic);
}

// For every effect that the plan leaves off: forced on, no pixel changes by more than one step of 8 bits.
TEST_F(FrameTest, ForcingAnEffectThatIsNotCalledForChangesNothing)
{
    const Baked baked = bakedEvenly(scene, vec3(0.7f));
    const Image8 plain = draw(scene, &baked, "auto");
    const Plan planned = plan(needs(scene), evidenceOf(scene, &baked), {});
    for (const char* effect : {"masked", "shadow", "probes", "reflections", "reflection", "clear", "planar", "portal", "fog", "occlusion",
                               "upscale", "bloom", "toon", "outline"}) {
        ASSERT_FALSE(planned.on(effect)) << effect;
        const Image8 forced = draw(scene, &baked, std::string("+") + effect);
        ASSERT_EQ(forced.pixels.size(), plain.pixels.size());
        int largest = 0;
        for (std::size_t i = 0; i < plain.pixels.size(); ++i)
            largest = std::max(largest, std::abs(int(forced.pixels[i]) - int(plain.pixels[i])));
        EXPECT_LE(largest, 1) << effect;
    }
}

// H91: what a level has none of, lamps, mirrors, water, portals, air and its phase function, glare, bands, leaves no trace: passes, and so
// their time, and bytes are those of ruling it out. Forced on, with nothing to do or at strength 0, it leaves every bit of the picture.
TEST_F(FrameTest, WhatALevelHasNoneOfLeavesNoTrace)
{
    const auto passes = [&] {
        std::vector<std::string> names;
        for (const PassStats& pass : stats.passes) names.push_back(pass.name);
        return names;
    };
    const Image8 plain = draw(scene, nullptr, "auto");
    const std::vector<std::string> few = passes();
    const std::uint64_t bytes = stats.gpuBytes;
    for (const std::string effect : {"shadow", "reflections", "reflection", "planar", "portal", "fog", "bloom", "toon"}) {
        EXPECT_FALSE(ran(effect)) << effect;
        EXPECT_EQ(draw(scene, nullptr, "-" + effect).pixels, plain.pixels) << effect;
        EXPECT_EQ(passes(), few) << effect;
        EXPECT_EQ(stats.gpuBytes, bytes) << effect;
        EXPECT_EQ(draw(scene, nullptr, "+" + effect).pixels, plain.pixels) << effect;
        EXPECT_GE(stats.gpuBytes, bytes) << effect;
    }
    draw(scene, nullptr, "+fog,+bloom,+toon,+reflection");
    for (const char* pass : {"fog", "bloom", "toon", "reflection"}) EXPECT_TRUE(ran(pass)) << pass;
    EXPECT_GT(stats.gpuBytes, bytes);
}

// A frame drawn smaller is shown at its size, whoever brings it there; and the picture is that of the whole frame, but for its detail.
TEST_F(FrameTest, AFrameDrawnSmallerIsShownAtItsSize)
{
    const Baked baked = bakedEvenly(scene, vec3(0.7f));
    const auto meanOf = [&](const std::string& effects, float scale, int frames) {
        Settings settings;
        settings.size = {61, 47};
        settings.renderScale = scale;
        settings.display.exposureEv = 0.0f;
        settings.effects = parseOverrides(effects);
        Stage stage = makeStage(gpu, scene, &baked, settings);
        Executor executor(gpu);
        Image picture;
        for (int i = 0; i < frames; ++i) {
            const View view = nextView(stage, camera, settings);
            EXPECT_EQ(view.frame, effects == "auto" ? uint(i) : 0u);
            EXPECT_EQ(view.size, scale < 1.0f ? uvec2(31, 24) : uvec2(61, 47));
            Graph graph;
            const Pictures pictures = drawFrame(graph, stage, view, settings);
            graph.output(pictures.radiance);
            stats = executor.run(graph, stage.level->set);
            picture = executor.download(pictures.radiance);
        }
        EXPECT_EQ(picture.width, 61);
        EXPECT_EQ(picture.height, 47);
        double sum = 0;
        for (std::size_t i = 0; i < picture.pixels.size(); i += 4) sum += double(picture.pixels[i]);
        return sum / (61.0 * 47.0);
    };
    const double whole = meanOf("auto", 1.0f, 16);
    EXPECT_NEAR(meanOf("auto", 0.5f, 16), whole, 0.02 * whole);
    EXPECT_FALSE(ran("upscale")) << "antialias does it";
    EXPECT_NEAR(meanOf("-antialias", 0.5f, 1), whole, 0.04 * whole);
    EXPECT_TRUE(ran("upscale"));
    EXPECT_FALSE(ran("antialias"));
    Settings settings;
    const auto frames = [&](const std::string& effects, float scale) {
        settings.renderScale = scale;
        return framesOf(plan(needs(scene), evidenceOf(scene, &baked, settings), parseOverrides(effects)), settings);
    };
    EXPECT_EQ(frames("-antialias", 0.5f), 1);
    EXPECT_EQ(frames("auto", 1.0f), 16);
    EXPECT_EQ(frames("auto", 0.5f), 64) << "as many samples in a shown pixel";
    EXPECT_EQ(frames("-upscale", 0.5f), 16) << "drawn at its own size";
}

TEST_F(FrameTest, IsNeitherBlackNorWhite)
{
    const Baked baked = bakedEvenly(scene, vec3(0.7f));
    const Image8 picture = draw(scene, &baked, "auto");
    double sum = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) sum += i % 4 == 3 ? 0 : picture.pixels[i];
    const double mean = sum / (double(picture.pixels.size()) * 0.75);
    EXPECT_GT(mean, 40);
    EXPECT_LT(mean, 215);
}

// H72: one pixel, one row, odd sizes.
TEST_F(FrameTest, DrawsAtAnySize)
{
    for (const uvec2 size : {uvec2(1, 1), uvec2(1, 7), uvec2(33, 1), uvec2(37, 23)}) {
        const Image8 picture = draw(scene, nullptr, "auto,+fog,+bloom", size);
        EXPECT_EQ(picture.width, int(size.x));
        EXPECT_EQ(picture.height, int(size.y));
    }
}

// H17: nothing at all, lights only.
TEST_F(FrameTest, AnEmptyLevelDrawsItsSky)
{
    Scene empty;
    empty.sky.radiance = vec3(0.5f);
    addLight(empty, sunLight(vec3(0, -1, 0), vec3(1.0f)));
    const Image8 picture = draw(empty, nullptr, "auto");
    EXPECT_GT(picture.pixels[0], 0);
    EXPECT_EQ(picture.pixels[0], picture.pixels[picture.pixels.size() - 4]);
}

// H66: a camera that has no picture is refused in words.
TEST_F(FrameTest, RefusesACameraWithoutAPicture)
{
    Camera flat = camera;
    flat.nearPlane = 0.0f;
    EXPECT_THROW(makeView(flat, {16, 16}), Error);
    flat = camera;
    flat.fovY = 3.2f;
    EXPECT_THROW(makeView(flat, {16, 16}), Error);
}

TEST_F(FrameTest, ARadianceOutputNeedsNoDisplay)
{
    Settings settings;
    settings.size = {16, 16};
    Stage stage = makeStage(gpu, scene, nullptr, settings);
    Graph graph;
    graph.output(drawFrame(graph, stage, makeView(camera, settings.size), settings).radiance);
    Executor executor(gpu);
    stats = executor.run(graph, stage.level->set);
    EXPECT_FALSE(ran("display"));
}
}
