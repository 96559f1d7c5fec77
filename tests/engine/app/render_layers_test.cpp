// The layers that `render --layers` writes: their names and channels, and that they recombine as half floats.
#include "engine/app/render_layers.hpp"
#include "engine/app/runtime_verbs.hpp"
#include "engine/core/error.hpp"
#include "tests/engine/gpu/validated.hpp"
#include "tests/engine/upload/toy_level.hpp"
#include <glm/gtc/packing.hpp>

namespace afterglow
{
class RenderLayers : public Validated
{
protected:
    RenderLayers()
    {
        Material glossy = matte(vec3(0.6f, 0.5f, 0.4f));
        glossy.flags = 0;
        glossy.roughness = 0.4f;
        addRoom(scene, vec3(-2), vec3(2), addMaterial(scene, glossy));
        Material lamp = matte(vec3(0.0f));
        lamp.emission = vec3(50.0f);
        addQuad(scene, vec3(-0.5f, 1.9f, -0.5f), vec3(1, 0, 0), vec3(0, 0, 1), addMaterial(scene, lamp));
        addLight(scene, pointLight(vec3(0, 1, 0), vec3(2.0f)));
        scene.sky.radiance = vec3(0.3f, 0.4f, 0.5f);
        Medium air{};
        air.scattering = vec3(0.1f);
        air.lower = vec3(-2), air.upper = vec3(2);
        scene.media.push_back(air);
        settings.size = {32, 24};
        settings.layers = true;
    }

    std::map<std::string, Image> draw(const std::string& effects, int frames)
    {
        settings.effects = parseOverrides(effects);
        settings = adoptLevel(settings, scene);
        Stage stage = makeStage(gpu, scene, nullptr, settings);
        Pictures pictures;
        for (int i = 0; i < frames; ++i) {
            Graph graph;
            pictures = drawFrame(graph, stage, nextView(stage, lookAt(vec3(-1.5f, -1, 1.5f), vec3(0, 1.2f, 0)), settings), settings);
            outputLayers(graph, pictures);
            executor.run(graph, stage.level->set);
        }
        displayed = executor.download(pictures.bloomed);
        std::map<std::string, Image> layers;
        channels.clear();
        for (const Layer& layer : downloadLayers(executor, pictures)) {
            channels += layer.name + (layer.letters.empty() ? "" : "." + layer.letters) + ' ';
            EXPECT_EQ(layer.image.width, 32) << layer.name;
            EXPECT_EQ(layer.image.height, 24) << layer.name;
            layers[layer.name] = layer.image;
        }
        return layers;
    }

    Scene scene;
    Settings settings;
    Executor executor{gpu};
    Image displayed;      // before exposure
    std::string channels; // of the layers; without letters: R G B, or Y
};

static float asHalf(float value) { return glm::unpackHalf1x16(glm::packHalf1x16(value)); }

constexpr float kHalfRounding = 4.8828125e-4f; // 2^-11
constexpr float kLeastHalf = 5.9604645e-8f;    // 2^-24

static constexpr const char* kEveryLayer =
    " beauty direct indirect reflection emission fog bloom ao depth.Z normal.XYZ motion.XYZW object_id.X material_id.X ";

// Sums as a compositor makes them of the file's halves.
TEST_F(RenderLayers, RecombineToTheBeautyAndToWhatIsDisplayed)
{
    scene.display.bloom = 0.3f;
    for (const float scale : {1.0f, 0.5f}) {
        settings.renderScale = scale;
        const std::map<std::string, Image> layers = draw("auto", 3);
        EXPECT_EQ(channels, kEveryLayer);
        const Image &beauty = layers.at("beauty"), &bloom = layers.at("bloom");
        EXPECT_EQ(layers.at("").pixels, beauty.pixels);
        double light = 0, added = 0, moved = 0;
        for (std::size_t i = 0; i < beauty.pixels.size(); ++i) {
            float sum = 0.0f;
            for (const char* part : {"direct", "indirect", "reflection", "emission", "fog"}) sum += asHalf(layers.at(part).pixels[i]);
            // A part is rounded to half where it was written, blended, and dimmed, and then in the file; so is the picture
            ASSERT_NEAR(sum, asHalf(beauty.pixels[i]), 4.0f * kHalfRounding * (sum + beauty.pixels[i]) + 1e-6f) << scale << ' ' << i;
            const float after = displayed.pixels[i / 3 * 4 + i % 3];
            ASSERT_NEAR(asHalf(beauty.pixels[i]) + asHalf(bloom.pixels[i]), after,
                        kHalfRounding * (beauty.pixels[i] + std::abs(bloom.pixels[i])) + kLeastHalf)
                << scale << ' ' << i;
            light += double(beauty.pixels[i]);
            added += double(bloom.pixels[i]);
            moved += std::abs(double(bloom.pixels[i]));
        }
        EXPECT_NEAR(added, 0.0, 1e-5 * light) << "what bloom brings it takes elsewhere";
        EXPECT_GT(moved, 0.01 * light);
    }
}

// What a frame has nothing of is in the file all the same.
TEST_F(RenderLayers, AreTheSameWhereTheFrameHasLess)
{
    const std::map<std::string, Image> layers = draw("none", 1);
    EXPECT_EQ(channels, kEveryLayer);
    for (const char* none : {"fog", "bloom", "motion"})
        for (const float value : layers.at(none).pixels) ASSERT_EQ(value, 0.0f) << none;
    for (const float value : layers.at("ao").pixels) ASSERT_EQ(value, 1.0f);
}

// Without antialias a smaller frame is brought to size by a filter that the parts' sum does not pass unchanged.
TEST_F(RenderLayers, AreRefusedOfAPictureThatIsOnlyStretched)
{
    RenderCommand command;
    command.target = "content/truth/furnace.glb";
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir());
    command.output = folder / "stretched.png";
    command.layers = folder / "stretched.exr";
    command.settings.size = {8, 8};
    command.settings.renderScale = 0.5f;
    command.settings.effects = parseOverrides("-antialias");
    EXPECT_THROW(renderVerb(command), Error);
    EXPECT_FALSE(std::filesystem::exists(command.output));
}
}
