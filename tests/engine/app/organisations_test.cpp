// One estimator, organised in several ways on the GPU: they draw the same random numbers for the same paths, so that their pictures are
// those of the kernel, pixel by pixel, up to what compilers round.
#include "tests/engine/app/tracers.hpp"
#include "tests/engine/upload/toy_level.hpp"

namespace afterglow
{
class Organisations : public Tracers
{
protected:
    void SetUp() override
    {
        if (!gpu.device.rayQuery) GTEST_SKIP() << gpu.device.deviceName << " traces in one way alone, if in any";
    }

    static constexpr double kOfOneCompiler = 0.999; // of the paths: one device, one text

    void compare(const std::string& name, const Scene& scene, const Camera& camera, uvec2 size, uint samples)
    {
        TruthOptions picture;
        picture.camera = camera;
        picture.size = ivec2(size);
        picture.samples = int(samples);
        const Image kernel = onGpu(scene, picture, Tracing::kernel);
        for (const auto& [word, tracing] : tracingWords())
            if (tracing != Tracing::automatic && tracing != Tracing::kernel && canTrace(gpu.device, tracing))
                expectAgreement(name + ", " + word, picture, onGpu(scene, picture, tracing), kernel, kOfOneCompiler);
    }
    void compareLevel(const std::string& name, uvec2 size, uint samples)
    {
        const Scene scene = loadLevel("content/" + name + ".glb");
        compare(name, scene, findCamera(scene, ""), size, samples);
    }
};

// Opaque, cut out, blended and clear surfaces, a lamp, an emitter and the sky through a hole: every program is asked.
TEST_F(Organisations, AgreeWhereRaysPassInPart)
{
    Scene scene;
    Material leaf = matte(vec3(0.3f, 0.6f, 0.2f)), sheet = matte(vec3(0.8f, 0.3f, 0.3f)), glass = matte(vec3(0.5f, 0.8f, 1.0f)),
             panel = matte(vec3(0.0f));
    leaf.flags |= kMaterialAlphaMask;
    leaf.baseColor.a = 0.4f; // below the cutoff: all of it is a hole
    sheet.flags |= kMaterialAlphaBlend;
    sheet.baseColor.a = 0.4f;
    glass.flags = 0u;
    glass.roughness = 0.0f;
    glass.transmission = 1.0f;
    panel.emission = vec3(8.0f);
    addRoom(scene, vec3(-2), vec3(2), addMaterial(scene, matte(vec3(0.7f))));
    scene.objects.erase(scene.objects.begin() + 3); // no near wall: the sky shines in
    addQuad(scene, vec3(-0.5f, 1.9f, -0.5f), vec3(1, 0, 0), vec3(0, 0, 1), addMaterial(scene, panel));
    addQuad(scene, vec3(-1.5f, -1.0f, 0), vec3(1, 0, 0), vec3(0, 2, 0), addMaterial(scene, leaf));
    addQuad(scene, vec3(-0.5f, -1.0f, 0.2f), vec3(1, 0, 0), vec3(0, 2, 0), addMaterial(scene, sheet));
    addQuad(scene, vec3(0.5f, -1.0f, 0.1f), vec3(1, 0, 0), vec3(0, 2, 0), addMaterial(scene, glass));
    Light lamp = pointLight(vec3(0.5f, 0.5f, 1.5f), vec3(3.0f));
    lamp.radius = 0.2f;
    addLight(scene, lamp);
    scene.sky.radiance = vec3(1.0f);
    compare("surfaces that let light through", scene, lookAt(vec3(0, 0, 6), vec3(0)), {32, 32}, 4);
}

TEST_F(Organisations, AgreeInAir)
{
    compareLevel("truth/fog_beam", {24, 24}, 4);
    compareLevel("truth/fog_glow", {24, 24}, 4);
}

// Whose directions are chosen by their brightness.
TEST_F(Organisations, AgreeUnderAPaintedSky)
{
    Scene scene;
    addQuad(scene, vec3(-9, 0, -9), vec3(0, 0, 18), vec3(18, 0, 0), addMaterial(scene, matte(vec3(0.6f))));
    scene.sky.radiance = vec3(1.0f);
    scene.sky.image = Image(8, 4, 3);
    for (std::size_t i = 0; i < scene.sky.image.pixels.size(); ++i) scene.sky.image.pixels[i] = 0.1f * float(i % 7);
    compare("a painted sky", scene, lookAt(vec3(0, 3, 6), vec3(0)), {24, 24}, 4);
}

TEST_F(Organisations, AgreeOnRooms)
{
    compareLevel("cornell/cornell", {32, 32}, 4);
    compareLevel("truth/portal", {24, 24}, 4);
}

// More of them than the wavefront has slots: a slot goes on to a pixel further down.
TEST_F(Organisations, AgreeOnManyPixels)
{
    constexpr uvec2 kMany{512, 300};
    static_assert(kMany.x * kMany.y > kMostSlots);
    Scene scene;
    addQuad(scene, vec3(-9, 0, -9), vec3(0, 0, 18), vec3(18, 0, 0), addMaterial(scene, matte(vec3(0.6f))));
    scene.sky.radiance = vec3(0.25f, 0.5f, 1.0f);
    compare("a floor under the sky", scene, lookAt(vec3(0, 3, 6), vec3(0)), kMany, 1);
}

// The sums of the frame before are gone on from.
TEST_F(Organisations, AgreeFrameByFrame)
{
    perFrame = 2;
    compareLevel("cornell/cornell", {32, 32}, 4);
}

TEST_F(Organisations, AgreeInAnEmptyLevel) { compareLevel("truth/nothing", {8, 8}, 4); }

TEST_F(Organisations, slowAgreeOnTexturedLevels)
{
    compareLevel("gallery/gallery", {48, 32}, 4);
    compareLevel("pool/pool", {48, 32}, 4);
}
}
