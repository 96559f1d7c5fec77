// What a picture's layers say of its surfaces: of the pixels' centres, however the frames sample; how far they have come; how open they
// lie.
#include "engine/frame/frame.hpp"
#include "tests/engine/gpu/validated.hpp"
#include "tests/engine/upload/toy_level.hpp"
#include <cmath>

namespace afterglow
{
class LayersOfSurfaces : public Validated
{
protected:
    LayersOfSurfaces()
    {
        settings.size = {48, 32};
        settings.layers = true;
    }

    // A board before a far wall, seen so that a metre is a pixel.
    void board()
    {
        scene.sky.radiance = vec3(1.0f);
        addMaterial(scene, matte(vec3(0.5f)));
        addQuad(scene, vec3(-90, -90, -9), vec3(180, 0, 0), vec3(0, 180, 0), 0);
        addQuad(scene, vec3(-5, -4, 0), vec3(10, 0, 0), vec3(0, 8, 0), 0);
    }
    static Camera flatEye(vec3 at)
    {
        Camera camera = lookAt(at, at - vec3(0, 0, 1));
        camera.fovY = 0.0f;
        camera.orthoHeight = 32.0f;
        return camera;
    }

    // The next frame of the picture.
    const Layers& frame(const Camera& camera)
    {
        if (!stage.level) stage = makeStage(gpu, scene, nullptr, settings);
        Graph graph;
        pictures = drawFrame(graph, stage, nextView(stage, camera, settings), settings);
        const Layers& l = pictures.layers;
        for (const Texture& texture : {pictures.radiance, l.indirect, l.occlusion, l.surface, l.ids, l.motion})
            if (texture) graph.output(texture);
        executor.run(graph, stage.level->set);
        return l;
    }
    // The picture from its beginning; its last layers.
    const Layers& afresh(const Camera& camera, int frames)
    {
        stage = {};
        for (int i = 1; i < frames; ++i) frame(camera);
        return frame(camera);
    }

    // px since the last frame and to the next, right and up, of a pixel that came by `came`.
    void expectCame(const Texture& motion, ivec2 pixel, vec2 came)
    {
        ASSERT_TRUE(motion);
        const Image image = executor.download(motion);
        for (int c = 0; c < 4; ++c)
            EXPECT_NEAR(image.at(pixel.x, pixel.y)[c], -came[c % 2], came == vec2(0) ? 0.0f : 1e-3f)
                << pixel.x << ' ' << pixel.y << ' ' << c;
    }

    Scene scene;
    Settings settings;
    Stage stage;
    Pictures pictures;
    Executor executor{gpu};
};

// The eye rests: what is not moved has no motion at all, whatever the jitter; and where all rests there is no layer.
TEST_F(LayersOfSurfaces, TellByHowManyPixelsAnObjectMoved)
{
    board();
    const Camera eye = flatEye(vec3(0, 0, 9));
    for (int i = 0; i < 3; ++i) EXPECT_FALSE(frame(eye).motion);
    scene.objects[1].toWorld[3] = dvec4(3, 2, 0, 1);
    move(gpu, stage, scene, 1);
    ASSERT_NE(nextView(stage, eye, settings).jitter, vec2(0));
    const Texture motion = frame(eye).motion;
    expectCame(motion, {26, 15}, {3, 2});
    expectCame(motion, {31, 10}, {3, 2}); // where it has come to
    expectCame(motion, {20, 18}, {0, 0}); // where it has left
    expectCame(motion, {2, 2}, {0, 0});
    EXPECT_FALSE(frame(eye).motion);
}

TEST_F(LayersOfSurfaces, TellByHowManyPixelsTheEyeMoved)
{
    board();
    frame(flatEye(vec3(0, 0, 9)));
    const Camera eye = flatEye(vec3(1, 0.5f, 9));
    Texture motion = frame(eye).motion;
    expectCame(motion, {24, 16}, {-1, -0.5f});
    expectCame(motion, {2, 2}, {-1, -0.5f});
    scene.objects[1].toWorld[3] = dvec4(3, 2, 0, 1);
    move(gpu, stage, scene, 1);
    motion = frame(flatEye(vec3(2, 1, 9))).motion;
    expectCame(motion, {24, 16}, {2, 1.5f});
    expectCame(motion, {2, 2}, {-1, -0.5f});
}

// An eye that turns sees the sky go by; what was behind it came from nowhere.
TEST_F(LayersOfSurfaces, TellTheMotionOfTheSkyAndNoneFromBehindTheEye)
{
    board();
    settings.size = {33, 33};
    constexpr float kTurned = 0.1f, kFov = 0.8f;
    frame(lookAt(vec3(0, 0, 20), vec3(0, 0, 30), kFov));
    const vec3 left(std::sin(kTurned), 0, std::cos(kTurned));
    Texture motion = frame(lookAt(vec3(0, 0, 20), vec3(0, 0, 20) + left, kFov)).motion;
    expectCame(motion, {16, 16}, {16.5f / std::tan(0.5f * kFov) * std::tan(kTurned), 0});

    afresh(lookAt(vec3(0, 0, -1), vec3(0, 0, -9), kFov), 1);
    motion = frame(lookAt(vec3(0, 0, 20), vec3(0), kFov)).motion;
    expectCame(motion, {16, 16}, {0, 0});
}

// After any number of frames, and drawn smaller, they are to the bit those of one frame that looks through the pixels' centres.
TEST_F(LayersOfSurfaces, AreOfThePixelsCentres)
{
    board();
    const Camera eye = lookAt(vec3(4, 3, 12), vec3(0, 1, 0));
    settings.effects = parseOverrides("-antialias");
    const Layers plain = afresh(eye, 1);
    const Image surface = executor.download(plain.surface), ids = executor.download(plain.ids);
    settings.effects = {};
    for (const float scale : {1.0f, 0.5f})
        for (const int frames : {1, 6}) {
            settings.renderScale = scale;
            const Layers gathered = afresh(eye, frames);
            ASSERT_TRUE(frames == 1 || scale < 1.0f || nextView(stage, eye, settings).jitter != vec2(0));
            EXPECT_EQ(executor.download(gathered.surface).pixels, surface.pixels) << scale << ' ' << frames;
            EXPECT_EQ(executor.download(gathered.ids).pixels, ids.pixels) << scale << ' ' << frames;
        }
}

// A room so dark that nothing bounces, under light from everywhere: what its matte walls send is the light times how open they lie. So are
// the means of both over the frames.
TEST_F(LayersOfSurfaces, TellHowOpenThePictureLies)
{
    constexpr float kDark = 1.0f / 225.0f; // 17 / 255 squared: the G-buffer holds it exactly
    scene.sky.radiance = vec3(1.0f / kDark);
    addRoom(scene, vec3(-1), vec3(1), addMaterial(scene, matte(vec3(kDark))));
    for (const float scale : {1.0f, 0.5f}) {
        settings.renderScale = scale;
        const Layers gathered = afresh(lookAt(vec3(0.3f, 0.2f, 0.9f), vec3(-0.4f, -0.5f, -1), 1.2f), 6);
        ASSERT_TRUE(gathered.occlusion);
        const Image open = executor.download(gathered.occlusion), sent = executor.download(gathered.indirect);
        EXPECT_EQ(open.width, 48);
        float least = 1.0f;
        for (int y = 0; y < open.height; ++y)
            for (int x = 0; x < open.width; ++x) {
                least = std::min(least, *open.at(x, y));
                // Both are halves, what is sent of three roundings
                ASSERT_NEAR(*open.at(x, y), *sent.at(x, y), 4.0f * 4.9e-4f) << scale << ' ' << x << ' ' << y;
            }
        EXPECT_LT(least, 0.6f) << "corners";
    }
}
}
