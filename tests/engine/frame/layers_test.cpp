// The parts of a picture: their sum is the picture, each holds its own kind of light, and nobody pays who does not ask.
#include "engine/frame/frame.hpp"
#include "shaders/constants.h"
#include "tests/engine/gpu/validated.hpp"
#include "tests/engine/upload/toy_level.hpp"

namespace afterglow
{
class LayersTest : public Validated
{
protected:
    // A room of glossy walls with a lamp, a point light, a window to the sky on its near side, and a pane of tinted glass.
    LayersTest()
    {
        Material glossy = matte(vec3(0.6f, 0.5f, 0.4f));
        glossy.flags = 0;
        glossy.roughness = 0.5f;
        addRoom(scene, vec3(-2), vec3(2), addMaterial(scene, glossy));
        scene.objects[3].toWorld[3].z = 40.0; // the near wall stands far off: the camera sees past it
        Material lamp = matte(vec3(0.0f));
        lamp.emission = vec3(5.0f);
        addQuad(scene, vec3(-0.5f, 1.9f, -0.5f), vec3(1, 0, 0), vec3(0, 0, 1), addMaterial(scene, lamp));
        Material glass = glossy;
        glass.transmission = 0.7f;
        glass.emission = vec3(0.1f, 0.0f, 0.0f);
        addQuad(scene, vec3(0, -2, -1), vec3(2, 0, 0), vec3(0, 2, 0), addMaterial(scene, glass));
        addLight(scene, pointLight(vec3(0, 1, 0), vec3(2.0f)));
        scene.sky.radiance = vec3(0.3f, 0.4f, 0.5f);
        baked = bakedEvenly(scene, vec3(0.7f));
        baked.reflections.push_back(evenReflection(vec3(-2), vec3(2), vec3(0.5f, 0.6f, 0.7f)));
        baked.scene = scene;
    }

    // Draws the frame, or the mean of several, and fetches what the names say.
    void draw(const Camera& camera, bool layers, int frames = 1)
    {
        Settings settings;
        settings.size = {64, 48};
        settings.layers = layers;
        settings = adoptLevel(settings, scene);
        Stage stage = makeStage(gpu, scene, &baked, settings);
        Pictures pictures;
        for (int i = 0; i < frames; ++i) {
            Graph graph;
            pictures = drawFrame(graph, stage, nextView(stage, camera, settings), settings);
            const Layers& parts = pictures.layers;
            graph.output(pictures.radiance);
            for (const Texture& texture :
                 {parts.direct, parts.indirect, parts.reflection, parts.emission, parts.fog, parts.surface, parts.ids})
                if (texture) graph.output(texture);
            stats = executor.run(graph, stage.level->set);
        }
        const Layers& l = pictures.layers;
        const auto fetch = [&](const Texture& texture) { return texture ? executor.download(texture) : Image(64, 48, 4); };
        picture = fetch(pictures.radiance);
        parts = {fetch(l.direct), fetch(l.indirect), fetch(l.reflection), fetch(l.emission), fetch(l.fog)};
        surface = fetch(l.surface), ids = fetch(l.ids);
    }

    // The parts against the picture, pixel by pixel; `total` is each part's sum.
    void expectSum(int frames)
    {
        draw(lookAt(vec3(-1.2f, 0.5f, 6), vec3(0.3f, -0.3f, -2)), true, frames);
        total = {};
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x)
                for (int c = 0; c < 3; ++c) {
                    float sum = 0.0f;
                    for (std::size_t k = 0; k < parts.size(); ++k) {
                        sum += parts[k].at(x, y)[c];
                        total[k] += double(parts[k].at(x, y)[c]);
                    }
                    // Each part and the picture is rounded to half, 2^-10 of what it holds at most: where it was written, blended, and
                    // dimmed
                    const float seen = picture.at(x, y)[c];
                    ASSERT_NEAR(sum, seen, 3.0f * 9.8e-4f * (sum + seen) * 0.5f + 1e-6f) << x << ' ' << y << ' ' << c;
                }
        for (std::size_t k = 0; k < 4; ++k) EXPECT_GT(total[k], 0.0) << "part " << k;
    }

    Scene scene;
    Baked baked;
    Executor executor{gpu};
    FrameStats stats;
    Image picture, surface, ids;
    std::array<Image, 5> parts;
    std::array<double, 5> total{};
};

// Of one frame, and of the mean of several.
class LayersSum : public LayersTest, public ::testing::WithParamInterface<int>
{
};
INSTANTIATE_TEST_SUITE_P(Frames, LayersSum, ::testing::Values(1, 5));

// Through fog, too, which dims four parts and is the fifth.
TEST_P(LayersSum, IsThePictureThroughFog)
{
    Medium air{};
    air.scattering = vec3(0.1f), air.absorption = vec3(0.0f, 0.1f, 0.2f), air.emission = vec3(0.02f);
    air.lower = vec3(-2), air.upper = vec3(2, 2, 5);
    scene.media.push_back(air);
    expectSum(GetParam());
    EXPECT_GT(total[4], 0.0);
}

// In steps, under lines and through fog: what is in steps mirrors nothing, a line is emission. A glossy wall that stays out of it mirrors.
TEST_P(LayersSum, IsThePictureInTonesAndLines)
{
    scene.display.toon = true;
    scene.display.outlinePixels = 2.0f;
    scene.display.outlineColor = vec3(0.1f, 0.2f, 0.3f);
    scene.materials[0].roughness = 0.1f;
    Medium air{};
    air.scattering = vec3(0.1f);
    air.lower = vec3(-2), air.upper = vec3(2, 2, 5);
    scene.media.push_back(air);
    expectSum(GetParam());
    const double inSteps = total[2]; // the glass mirrors
    scene.toonRamps[0] = {};
    expectSum(GetParam());
    EXPECT_GT(total[2], 1.5 * inSteps);
}

// Walls of roughness 0.5 mirror the probes, of 0.1 the picture too.
TEST_P(LayersSum, IsThePicture)
{
    std::array<double, 2> mirrored{};
    for (const int glossy : {0, 1}) {
        scene.materials[0].roughness = glossy ? 0.1f : 0.5f;
        expectSum(GetParam());
        EXPECT_EQ(total[4], 0.0);
        mirrored[std::size_t(glossy)] = total[2];
    }
    EXPECT_NE(mirrored[0], mirrored[1]);
}

TEST_F(LayersTest, TellDepthAlongTheAxisNormalsAndIds)
{
    draw(lookAt(vec3(0, 0.5f, 1), vec3(0, 0.5f, -2), 0.6f), true);
    for (const ivec2 pixel : {ivec2(1, 1), ivec2(32, 24), ivec2(62, 46)}) {
        const float* s = surface.at(pixel.x, pixel.y);
        EXPECT_NEAR(s[3], 3.0f, 1e-4f);
        EXPECT_NEAR(s[2], 1.0f, 1e-4f) << "the far wall looks towards +z";
        EXPECT_EQ(ids.at(pixel.x, pixel.y)[0], 3.0f) << "the far wall is the third object";
        EXPECT_EQ(ids.at(pixel.x, pixel.y)[1], 1.0f);
    }
}

TEST_F(LayersTest, SayThatTheSkyIsNoSurface)
{
    draw(lookAt(vec3(0, 10, 6), vec3(0, 20, 6.5f)), true);
    EXPECT_EQ(surface.at(32, 24)[3], 1e10f);
    EXPECT_EQ(ids.at(32, 24)[0], 0.0f);
    EXPECT_EQ(ids.at(32, 24)[1], 0.0f);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(parts[3].at(32, 24)[c], scene.sky.radiance[c], 1e-3f);
}

TEST_F(LayersTest, CostNothingUnlessAskedFor)
{
    const Camera camera = lookAt(vec3(-1.2f, 0.5f, 6), vec3(0.3f, -0.3f, -2));
    draw(camera, true);
    const Image with = picture;
    draw(camera, false);
    EXPECT_EQ(picture.pixels, with.pixels);
    for (const PassStats& pass : stats.passes) {
        EXPECT_NE(pass.name.rfind("layers.", 0), 0u) << pass.name;
        if (pass.name == "lighting") {
            EXPECT_EQ(pass.writes.size(), 1u);
        }
    }
}
}
