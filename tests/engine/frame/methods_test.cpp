// By which method a frame is made: each builds what it needs and no other, and without ray queries a sentence says what came instead.
#include "tests/engine/frame/frame.hpp"

namespace afterglow
{
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

// The filter has a pass where rays scatter, and none where they do not, or where nobody wants it; forced on, rays to a point stay as they
// are.
TEST_F(FrameTest, FiltersOnlyWhatRaysScatter)
{
    if (!gpu.device.rayQuery) GTEST_SKIP() << gpu.device.deviceName << " has no ray queries";
    addLight(scene, pointLight(vec3(0), vec3(1.0f)));
    Settings settings;
    settings.size = {32, 32};
    settings.shadowMethod = ShadowMethod::ray;
    settings.occlusionMethod = OcclusionMethod::ray;
    const auto drawn = [&](const std::string& effects) {
        settings.effects = parseOverrides(effects);
        Stage stage = makeStage(gpu, scene, nullptr, settings);
        Executor executor(gpu);
        Graph graph;
        const Texture picture = drawFrame(graph, stage, nextView(stage, camera, settings), settings).displayed;
        graph.output(picture);
        stats = executor.run(graph, stage.level->set);
        return executor.download(picture);
    };
    const Image point = drawn("none,+shadow,+occlusion");
    EXPECT_FALSE(ran("shadow.denoise"));
    EXPECT_FALSE(ran("occlusion.denoise"));
    EXPECT_TRUE(ran("occlusion.smooth"));
    EXPECT_EQ(drawn("none,+shadow,+occlusion,+shadow.denoise").pixels, point.pixels);
    EXPECT_TRUE(ran("shadow.denoise"));
    scene.lights[0].radius = 0.2f;
    drawn("-antialias,+occlusion");
    EXPECT_TRUE(ran("shadow.denoise"));
    EXPECT_TRUE(ran("occlusion.denoise"));
    EXPECT_FALSE(ran("occlusion.smooth"));
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
        EXPECT_TRUE(pass.name.rfind("truth", 0) == 0 || pass.name.rfind("bloom", 0) == 0 || pass.name.rfind("display", 0) == 0)
            << pass.name;
    EXPECT_EQ(stage.traced.count, 1u);
    forget(stage);
    EXPECT_EQ(stage.traced.count, 0u);
}

// No stage, but a sentence, which names the device, and exit 4: what is asked for by name is not replaced.
static void expectRefusal(Gpu& gpu, const Scene& scene, const Settings& settings, const std::string& option, const std::string& why)
{
    try {
        makeStage(gpu, scene, nullptr, settings);
        ADD_FAILURE() << option << ": nothing stands in for it";
    } catch (const Error& error) {
        EXPECT_EQ(error.exit, Exit::noDevice);
        EXPECT_EQ(error.what(), option + ": " + gpu.device.deviceName + " " + why);
    }
}

TEST_F(FrameTest, WithoutRaysThereIsNoTruthAndASentenceSaysSo)
{
    DeviceOptions options = validatedOptions();
    options.rayQuery = options.rayPipeline = false;
    Gpu poor(options);
    Settings settings;
    settings.mode = Mode::truth;
    expectRefusal(poor, scene, settings, "--mode truth", "traces no rays; `afterglow truth` traces the same paths on the CPU");
}

// As an Nvidia H100 is. The same paths, of which Organisations holds every picture against the CPU's.
TEST_F(FrameTest, WithRayProgramsAlonePathsAreTracedByThemAndASentenceSaysSo)
{
    DeviceOptions options = validatedOptions();
    options.rayQuery = false;
    Gpu poor(options);
    if (!poor.device.rayPipeline) GTEST_SKIP() << poor.device.deviceName << " has no ray-tracing pipelines";
    Settings settings;
    settings.size = {32, 32};
    settings.mode = Mode::truth;
    Stage stage = makeStage(poor, scene, nullptr, settings);
    EXPECT_EQ(stage.tracing, Tracing::pipeline);
    Graph graph;
    graph.output(drawTruth(graph, stage, camera, settings).displayed);
    Executor executor(poor);
    stats = executor.run(graph, stage.level->set);
    EXPECT_TRUE(ran("truth"));
    for (const std::string& message : poor.device.messages) ADD_FAILURE() << message;
    settings.tracing = Tracing::wavefront;
    expectRefusal(poor, scene, settings, "--tracing wavefront", "has no ray queries; --tracing pipeline traces the same paths");
}

TEST_F(FrameTest, WithoutRayPipelinesOthersTraceAndASentenceSaysSo)
{
    DeviceOptions options = validatedOptions();
    options.rayPipeline = false;
    Gpu poor(options);
    if (!poor.device.rayQuery) GTEST_SKIP() << poor.device.deviceName << " has no ray queries";
    EXPECT_FALSE(poor.device.rayPipeline);
    Settings settings;
    settings.mode = Mode::truth;
    EXPECT_NE(makeStage(poor, scene, nullptr, settings).tracing, Tracing::pipeline);
    settings.tracing = Tracing::pipeline;
    expectRefusal(poor, scene, settings, "--tracing pipeline", "has no ray-tracing pipelines; --tracing kernel traces the same paths");
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
}
