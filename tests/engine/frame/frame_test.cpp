// Whole frames: off costs nothing, forced on changes nothing, odd sizes and empty levels draw, a steady frame allocates nothing.
#include "engine/core/error.hpp"
#include "engine/frame/frame.hpp"
#include "engine/gpu/readback.hpp"
#include "tests/engine/gpu/validated.hpp"
#include "tests/engine/upload/solids.hpp"
#include <cmath>

namespace afterglow
{
class FrameTest : public Validated
{
protected:
    // A white room lit by an emissive ceiling panel, seen from a corner; baked or not.
    FrameTest()
    {
        addRoom(scene, vec3(-2), vec3(2), addMaterial(scene, matte(vec3(0.6f, 0.5f, 0.4f))));
        Material lamp = matte(vec3(0.0f));
        lamp.emission = vec3(5.0f);
        addQuad(scene, vec3(-0.5f, 1.9f, -0.5f), vec3(1, 0, 0), vec3(0, 0, 1), addMaterial(scene, lamp));
        camera = lookAt(vec3(-1.5f, 0, 1.5f), vec3(1, -0.5f, -1));
    }

    Image8 draw(const Scene& level, const Baked* baked, const std::string& effects, uvec2 size = {64, 48})
    {
        Settings settings;
        settings.size = size;
        settings.effects = parseOverrides(effects);
        settings.occlusionMethod = occlusionMethod;
        settings.reflectionMethod = reflectionMethod;
        Stage stage = makeStage(gpu, level, baked, settings);
        Graph graph;
        const Pictures pictures = drawFrame(graph, stage, makeView(camera, size), settings);
        graph.output(pictures.displayed);
        Executor executor(gpu);
        stats = executor.run(graph, stage.level->set);
        return readback8(gpu.memory, executor.image(pictures.displayed));
    }

    bool ran(const std::string& pass) const
    {
        for (const PassStats& p : stats.passes)
            if (p.name.rfind(pass, 0) == 0) return true;
        return false;
    }

    Scene scene;
    Camera camera;
    FrameStats stats;
    OcclusionMethod occlusionMethod = OcclusionMethod::automatic;
    ReflectionMethod reflectionMethod = ReflectionMethod::screen;
};

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

// An object that is moved takes its shadow along: the maps are drawn again, once.
TEST_F(FrameTest, WhatIsMovedIsDrawnElsewhere)
{
    addLight(scene, pointLight(vec3(0, 1, 0), vec3(1.0f)));
    addQuad(scene, vec3(-0.3f, -1.0f, -0.3f), vec3(0, 0, 0.6f), vec3(0.6f, 0, 0), 0);
    Settings settings;
    settings.size = {32, 24};
    Stage stage = makeStage(gpu, scene, nullptr, settings);
    Executor executor(gpu);
    const auto frame = [&] {
        Graph graph;
        const Pictures pictures = drawFrame(graph, stage, nextView(stage, camera, settings), settings);
        graph.output(pictures.displayed);
        stats = executor.run(graph, stage.level->set);
    };
    frame();
    frame();
    EXPECT_FALSE(ran("shadow"));
    EXPECT_FALSE(ran("antialias.motion"));
    scene.objects.back().toWorld[3] = dvec4(0.5, 0.2, 0.0, 1.0);
    move(gpu, stage, scene, uint(scene.objects.size() - 1));
    frame();
    EXPECT_TRUE(ran("shadow"));
    EXPECT_TRUE(ran("antialias.motion"));
    frame();
    EXPECT_FALSE(ran("shadow"));
    EXPECT_FALSE(ran("antialias.motion"));
}

// What rays meet and what mirrors show is where it is now: the picture is that of a level which had it there from the start.
TEST_F(FrameTest, RaysAndMirrorsFollowWhatIsMoved)
{
    addLight(scene, pointLight(vec3(0, 1, 0), vec3(1.0f)));
    addQuad(scene, vec3(-0.3f, -1.0f, -0.3f), vec3(0, 0, 0.6f), vec3(0.6f, 0, 0), 0);
    const uint plate = uint(scene.objects.size() - 1);
    Material silver = matte(vec3(1.0f));
    silver.flags = kMaterialMirror;
    silver.metallic = 1.0f;
    silver.roughness = 0.0f;
    addQuad(scene, vec3(1.5f, -1, -1), vec3(0, 0, 2), vec3(0, 2, 0), addMaterial(scene, silver)); // faces -x
    const uint mirror = uint(scene.objects.size() - 1);
    Settings settings;
    settings.size = {32, 24};
    settings.shadowMethod = gpu.device.rayQuery ? ShadowMethod::ray : ShadowMethod::map;
    Executor executor(gpu);
    const auto frame = [&](Stage& stage) {
        Graph graph;
        const Texture radiance = drawFrame(graph, stage, makeView(camera, settings.size), settings).radiance;
        graph.output(radiance);
        executor.run(graph, stage.level->set);
        return executor.download(radiance).pixels;
    };
    Stage stage = makeStage(gpu, scene, nullptr, settings);
    const std::vector<float> before = frame(stage);
    scene.objects[plate].toWorld[3] = dvec4(0.5, 0.25, 0.0, 1.0);
    scene.objects[mirror].toWorld[3] = dvec4(-0.5, 0.0, -0.25, 1.0);
    for (const uint object : {plate, mirror}) move(gpu, stage, scene, object);
    forget(stage);
    const std::vector<float> after = frame(stage);
    EXPECT_NE(after, before);
    Stage there = makeStage(gpu, scene, nullptr, settings);
    EXPECT_EQ(after, frame(there));
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

TEST_F(FrameTest, ASteadyFrameAllocatesNothingAndKeepsItsShadows)
{
    addLight(scene, pointLight(vec3(0), vec3(1.0f)));
    Settings settings;
    settings.size = {32, 32};
    Stage stage = makeStage(gpu, scene, nullptr, settings);
    Executor executor(gpu);
    std::uint32_t allocations = 0;
    std::vector<std::uint8_t> first;
    for (int i = 0; i < 4; ++i) {
        Graph graph;
        const Pictures pictures = drawFrame(graph, stage, makeView(camera, settings.size), settings);
        graph.output(pictures.displayed);
        stats = executor.run(graph, stage.level->set);
        const Image8 picture = readback8(gpu.memory, executor.image(pictures.displayed));
        if (i == 0) {
            EXPECT_TRUE(ran("shadow"));
            first = picture.pixels;
        } else {
            EXPECT_FALSE(ran("shadow")) << "a level holds still";
            EXPECT_EQ(picture.pixels, first);
        }
        if (i == 2) allocations = gpu.memory.allocations();
    }
    EXPECT_LE(gpu.memory.allocations(), allocations + 2) << "two buffers of the readback";
}

// Shadows by ray query need no map, but for the air and for what is drawn over the surfaces; nothing is built that nobody traces.
TEST_F(FrameTest, BuildsATreeOnlyForRaysAndMapsOnlyForWhatRaysDoNotKnow)
{
    if (!gpu.device.rayQuery) GTEST_SKIP() << gpu.device.deviceName << " has no ray queries";
    addLight(scene, pointLight(vec3(0), vec3(1.0f)));
    Settings settings;
    settings.size = {32, 32};
    Stage plain = makeStage(gpu, scene, nullptr, settings);
    EXPECT_FALSE(plain.level->scene.rays);
    EXPECT_TRUE(plain.shadows.atlas);

    settings.shadowMethod = ShadowMethod::ray;
    Stage traced = makeStage(gpu, scene, nullptr, settings);
    EXPECT_TRUE(traced.level->scene.rays);
    EXPECT_FALSE(traced.shadows.atlas);
    for (const PlannedEffect& effect : traced.plan.effects)
        if (effect.effect == "shadow") {
            EXPECT_EQ(effect.reason, "1 light whose direct part is drawn here, by ray query");
        }

    settings.effects = parseOverrides("+fog");
    EXPECT_TRUE(makeStage(gpu, scene, nullptr, settings).shadows.atlas) << "the air has maps";
    settings.effects = parseOverrides("-shadow");
    Stage off = makeStage(gpu, scene, nullptr, settings);
    EXPECT_FALSE(off.level->scene.rays);
    EXPECT_FALSE(off.shadows.atlas);

    settings.effects = parseOverrides("none");
    EXPECT_FALSE(makeStage(gpu, scene, nullptr, settings).level->scene.rays);
    settings.occlusionMethod = OcclusionMethod::ray;
    EXPECT_FALSE(makeStage(gpu, scene, nullptr, settings).level->scene.rays);
    settings.effects = parseOverrides("none,+occlusion");
    EXPECT_TRUE(makeStage(gpu, scene, nullptr, settings).level->scene.rays) << "occlusion traces them";
    settings.occlusionMethod = OcclusionMethod::hbao;
    settings.reflectionMethod = ReflectionMethod::ray;
    EXPECT_FALSE(makeStage(gpu, scene, nullptr, settings).level->scene.rays);
    settings.effects = parseOverrides("none,+reflection");
    EXPECT_TRUE(makeStage(gpu, scene, nullptr, settings).level->scene.rays) << "so does reflection";
}

TEST_F(FrameTest, WithoutRayQueriesWhatComesNextIsDrawnAndASentenceSaysSo)
{
    DeviceOptions options = validatedOptions();
    options.rayQuery = false;
    Gpu poor(options);
    EXPECT_FALSE(poor.device.rayQuery);
    addLight(scene, pointLight(vec3(0), vec3(1.0f)));
    Settings settings;
    settings.size = {32, 32};
    settings.shadowMethod = ShadowMethod::ray;
    settings.occlusionMethod = OcclusionMethod::ray;
    settings.reflectionMethod = ReflectionMethod::ray;
    settings.effects = parseOverrides("+occlusion,+reflection");
    Stage stage = makeStage(poor, scene, nullptr, settings);
    ASSERT_GE(stage.notes.size(), 3u);
    EXPECT_EQ(stage.notes[0], "--shadows ray: " + poor.device.deviceName + " has no ray queries, so shadow maps are drawn instead");
    EXPECT_EQ(stage.notes[1], "--ao ray: " + poor.device.deviceName + " has no ray queries, so hbao is drawn instead");
    EXPECT_EQ(stage.notes[2],
              "--reflections ray: " + poor.device.deviceName + " has no ray queries, so the picture itself is mirrored instead");
    EXPECT_TRUE(stage.shadows.atlas);
    Graph graph;
    const Pictures pictures = drawFrame(graph, stage, makeView(camera, settings.size), settings);
    graph.output(pictures.displayed);
    Executor executor(poor);
    stats = executor.run(graph, stage.level->set);
    EXPECT_TRUE(ran("shadow"));
    EXPECT_TRUE(ran("occlusion.hbao"));
    EXPECT_TRUE(ran("reflection.trace"));
    for (const std::string& message : poor.device.messages) ADD_FAILURE() << message;
}

// In place of the frame's passes, all but those that show radiance; a raster frame holds nothing for it, and no pass of it.
TEST_F(FrameTest, PathsStandForTheWholeFrame)
{
    draw(scene, nullptr, "auto");
    EXPECT_FALSE(ran("truth"));
    if (!gpu.device.rayQuery) GTEST_SKIP() << gpu.device.deviceName << " has no ray queries";
    Settings settings;
    settings.size = {8, 8};
    addSphere(scene, 0);
    const Stage raster = makeStage(gpu, scene, nullptr, settings);
    EXPECT_EQ(raster.memory, nullptr);
    EXPECT_TRUE(raster.level->scene.draws.back().closed);
    settings.mode = Mode::truth;
    settings.effects = parseOverrides("all");
    Stage stage = makeStage(gpu, scene, nullptr, settings);
    EXPECT_FALSE(stage.level->scene.draws.back().closed) << "nobody asks";
    EXPECT_EQ(framesOf(stage.plan, settings), int(settings.truth.samples));
    Graph graph;
    const Pictures pictures = drawTruth(graph, stage, camera, settings);
    graph.output(pictures.displayed);
    Executor executor(gpu);
    stats = executor.run(graph, stage.level->set);
    EXPECT_TRUE(ran("truth"));
    EXPECT_TRUE(ran("bloom"));
    for (const PassStats& pass : stats.passes)
        EXPECT_TRUE(pass.name == "truth" || pass.name.rfind("bloom", 0) == 0 || pass.name.rfind("display", 0) == 0) << pass.name;
    EXPECT_EQ(stage.traced.count, 1u);
    forget(stage);
    EXPECT_EQ(stage.traced.count, 0u);
}

TEST_F(FrameTest, WithoutRayQueriesThereIsNoTruthAndASentenceSaysSo)
{
    DeviceOptions options = validatedOptions();
    options.rayQuery = false;
    Gpu poor(options);
    Settings settings;
    settings.mode = Mode::truth;
    try {
        makeStage(poor, scene, nullptr, settings);
        ADD_FAILURE() << "nothing can stand in for ray queries";
    } catch (const Error& error) {
        EXPECT_EQ(error.exit, Exit::noDevice);
        EXPECT_EQ(error.what(),
                  "--mode truth: " + poor.device.deviceName + " has no ray queries; `afterglow truth` traces the same paths on the CPU");
    }
}

// Cascades are drawn when the eye has moved far enough to need it, and only they; without a sun they cost nothing.
TEST_F(FrameTest, CascadesFollowTheEye)
{
    draw(scene, nullptr, "auto,+shadow");
    const std::uint64_t without = stats.gpuBytes;
    draw(scene, nullptr, "auto,+shadow,+shadow.cascades");
    EXPECT_EQ(stats.gpuBytes, without);

    addQuad(scene, vec3(-200, -3, -200), vec3(0, 0, 400), vec3(400, 0, 0), 0);
    addLight(scene, sunLight(vec3(0.5f, -1, 0.2f), vec3(1.0f)));
    Settings settings;
    settings.size = {32, 32};
    settings.effects = parseOverrides("+shadow.cascades");
    Stage stage = makeStage(gpu, scene, nullptr, settings);
    Executor executor(gpu);
    const auto frame = [&](float x) {
        Graph graph;
        graph.output(drawFrame(graph, stage, makeView(lookAt(vec3(x, 0, 0), vec3(x + 1, 0, 0)), settings.size), settings).displayed);
        stats = executor.run(graph, stage.level->set);
    };
    frame(0.0f);
    EXPECT_TRUE(ran("shadow"));
    EXPECT_FALSE(ran("shadow.cascades"));
    frame(0.0f);
    EXPECT_FALSE(ran("shadow")) << "the eye rests";
    frame(5.0f);
    EXPECT_TRUE(ran("shadow.cascades"));
    frame(5.0f);
    EXPECT_FALSE(ran("shadow"));
}

// Where nothing is baked and the sky shines, contact is called for; each method is a pass of its own, and its memory goes with it.
TEST_F(FrameTest, OcclusionIsDrawnByTheMethodAskedFor)
{
    scene.sky.radiance = vec3(1.0f);
    const Image8 without = draw(scene, nullptr, "-occlusion");
    EXPECT_FALSE(ran("occlusion"));
    const char* rays = gpu.device.rayQuery ? "occlusion.ray" : "occlusion.hbao";
    for (const auto& [method, pass] : {std::pair(OcclusionMethod::automatic, "occlusion.hbao"),
                                       {OcclusionMethod::ssao, "occlusion.ssao"},
                                       {OcclusionMethod::hbao, "occlusion.hbao"},
                                       {OcclusionMethod::voxel, "occlusion.voxel"},
                                       {OcclusionMethod::ray, rays}}) {
        occlusionMethod = method;
        EXPECT_NE(draw(scene, nullptr, "auto").pixels, without.pixels) << pass;
        EXPECT_TRUE(ran(pass)) << pass;
    }
}

// The level has a polished panel: by either method it is mirrored in, and neither pays for the other.
TEST_F(FrameTest, ReflectionIsDrawnByTheMethodAskedFor)
{
    Material polished = matte(vec3(0.9f));
    polished.flags = 0u;
    polished.metallic = 1.0f;
    polished.roughness = 0.1f;
    addQuad(scene, vec3(-2, -1.9f, -2), vec3(0, 0, 4), vec3(4, 0, 0), addMaterial(scene, polished));
    const Baked baked = bakedEvenly(scene, vec3(0.7f));
    const Image8 without = draw(scene, &baked, "-reflection");
    EXPECT_FALSE(ran("reflection"));
    EXPECT_NE(draw(scene, &baked, "auto").pixels, without.pixels);
    EXPECT_TRUE(ran("reflection.depth"));
    EXPECT_FALSE(ran("reflection.rays"));
    if (!gpu.device.rayQuery) return;
    reflectionMethod = ReflectionMethod::ray;
    EXPECT_NE(draw(scene, &baked, "auto").pixels, without.pixels);
    EXPECT_TRUE(ran("reflection.rays"));
    EXPECT_FALSE(ran("reflection.depth") || ran("reflection.trace"));
    draw(scene, &baked, "-reflection");
    EXPECT_FALSE(ran("reflection"));
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
