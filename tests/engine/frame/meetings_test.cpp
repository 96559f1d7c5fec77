// Where two effects meet: what one leaves to the other, pixel by pixel.
#include "engine/frame/frame.hpp"
#include "tests/engine/gpu/validated.hpp"
#include "tests/engine/upload/toy_level.hpp"

namespace afterglow
{
class MeetingsTest : public Validated
{
protected:
    Scene scene;
    Settings settings;
    Executor executor{gpu};

    MeetingsTest()
    {
        settings.size = {64, 48};
        scene.sky.radiance = vec3(0.5f, 0.6f, 0.7f);
    }

    static Material metal(float roughness)
    {
        Material m = matte(vec3(0.9f));
        m.flags = 0;
        m.metallic = 1.0f;
        m.roughness = roughness;
        return m;
    }

    Image draw(const Camera& camera, const std::string& effects)
    {
        settings.effects = parseOverrides(effects);
        Stage stage = makeStage(gpu, scene, nullptr, settings);
        Graph graph;
        const Texture radiance = drawFrame(graph, stage, makeView(camera, settings.size), settings).radiance;
        graph.output(radiance);
        executor.run(graph, stage.level->set);
        return executor.download(radiance);
    }

    const float* at(const Image& image, const Camera& camera, vec3 world) const
    {
        const vec4 clip = makeView(camera, settings.size).worldToClip * vec4(world, 1.0f);
        const ivec2 pixel((vec2(clip) / clip.w * 0.5f + 0.5f) * vec2(settings.size));
        return image.at(pixel.x, pixel.y);
    }
};

// A polished floor before a mirror on the wall. What the mirror shows is added after the screen was reflected: the floor does not know it,
// and mirrors there what it would without the screen; it is not black.
TEST_F(MeetingsTest, AScreenReflectionOfAPlanarMirrorIsUnknown)
{
    addQuad(scene, vec3(-9, 0, 9), vec3(18, 0, 0), vec3(0, 0, -18), addMaterial(scene, metal(0.05f)));
    addQuad(scene, vec3(-3, 0, -3), vec3(6, 0, 0), vec3(0, 4, 0), addMaterial(scene, metal(0.0f))).mirror = true;
    const Camera camera = lookAt(vec3(0, 1.2f, 2), vec3(0, 0.3f, -3));
    const vec3 floor(0, 0, -1); // sees (0, 0.8, -3) of the mirror
    const Image with = draw(camera, "auto,+planar,+reflection"), without = draw(camera, "auto,+planar,-reflection");
    for (int c = 0; c < 3; ++c) {
        EXPECT_GT(at(without, camera, floor)[c], 0.1f);
        EXPECT_NEAR(at(with, camera, floor)[c], at(without, camera, floor)[c], 2e-3f) << c;
    }
}

// All that can be forced, on a glossy level that has no bake to read.
TEST_F(MeetingsTest, EverythingAtOnceWithoutABakeIsFinite)
{
    addRoom(scene, vec3(-2), vec3(2), addMaterial(scene, metal(0.1f)));
    scene.objects[3].mirror = true;
    addLight(scene, pointLight(vec3(0, 1, 0), vec3(3.0f)));
    const Image picture = draw(lookAt(vec3(-1.5f, 0, 1), vec3(1, -0.5f, -1)), "all");
    double sum = 0.0;
    for (const float value : picture.pixels) {
        ASSERT_TRUE(std::isfinite(value));
        sum += double(value);
    }
    EXPECT_GT(sum, 1.0);
}
}
