#include "engine/core/error.hpp"
#include "engine/gpu/readback.hpp"
#include "engine/upload/gpu_scene.hpp"
#include "engine/upload/scene_set.hpp"
#include "shaders/gbuffer.h"
#include "tests/engine/gpu/validated.hpp"
#include "tests/engine/upload/toy_level.hpp"

namespace afterglow
{
using GpuSceneTest = Validated;

TEST_F(GpuSceneTest, BuffersHoldTheStructsAsTheyAre)
{
    Scene scene;
    addRoom(scene, vec3(-1), vec3(1), addMaterial(scene, matte(vec3(0.5f))));
    const GpuScene uploaded = uploadScene(gpu, scene, instances(scene), {});
    const std::vector<std::uint8_t> bytes = readback(gpu.memory, uploaded.vertices);
    ASSERT_EQ(bytes.size(), scene.vertices.size() * sizeof(Vertex));
    EXPECT_EQ(std::memcmp(bytes.data(), scene.vertices.data(), bytes.size()), 0);
    EXPECT_EQ(uploaded.draws.size(), 6u);
    EXPECT_EQ(uploaded.lower, vec3(-1));
    EXPECT_EQ(uploaded.upper, vec3(1));
    EXPECT_FALSE(uploaded.lights) << "no light, no buffer";
    EXPECT_FALSE(uploaded.media);
}

// Levels of detail turn by no more than gloss hides: that of the smoothest texel, whatever the factor says.
TEST_F(GpuSceneTest, DrawsKnowTheNarrowestLobe)
{
    Scene scene;
    Material glossy = matte(vec3(0.5f));
    glossy.flags = 0;
    glossy.roughness = 0.8f;
    SceneTexture texture;
    texture.image = {2, 1, 4, {0, 255, 0, 255, 0, 51, 0, 255}}; // roughness in green: 1 and 0.2
    scene.textures.push_back(texture);
    Material textured = glossy;
    textured.metallicRoughnessTexture.texture = 0;
    for (const Material& material : {matte(vec3(0.5f)), glossy, textured}) addRoom(scene, vec3(-1), vec3(1), addMaterial(scene, material));
    std::vector<MeshLods> lods;
    for (const Mesh& mesh : scene.meshes)
        lods.push_back({std::vector(mesh.primitives.size(), std::vector{LodLevel{{0, 1, 2}, 0.1f, 0.2f}})});
    const GpuScene uploaded = uploadScene(gpu, scene, instances(scene), {}, lods);
    ASSERT_EQ(uploaded.draws.size(), 18u);
    EXPECT_FLOAT_EQ(uploaded.draws[0].alpha, 1.0f);
    EXPECT_FLOAT_EQ(uploaded.draws[6].alpha, 0.64f);
    EXPECT_FLOAT_EQ(uploaded.draws[12].alpha, 0.0256f);
}

// The G-buffer names a material in 15 bits: one more would wrap around to the first.
TEST_F(GpuSceneTest, RefusesMoreMaterialsThanTheGBufferTellsApart)
{
    Scene scene;
    scene.materials.assign(kGBufferMaterials, matte(vec3(0.5f)));
    uploadScene(gpu, scene, {}, {});
    scene.materials.push_back(matte(vec3(0.5f)));
    EXPECT_THROW(uploadScene(gpu, scene, {}, {}), Error);
}

// And a page of the lightmap in 8, of which two say that there is none.
TEST_F(GpuSceneTest, RefusesMoreLightmapsThanTheGBufferTellsApart)
{
    Baked baked;
    baked.lightmaps.resize(kGBufferBackPage + 1);
    EXPECT_THROW(uploadBaked(gpu, baked, {}), Error);
}

TEST_F(GpuSceneTest, UploadsOnlyWhatShadersRead)
{
    Scene scene;
    addRoom(scene, vec3(-1), vec3(1), addMaterial(scene, matte(vec3(0.5f))));
    const std::uint64_t before = gpu.memory.bytes();
    const GpuScene uploaded = uploadScene(gpu, scene, instances(scene), {});
    const std::uint64_t taken = gpu.memory.bytes() - before;
    std::uint64_t read = 0, most = 0; // most: a buffer of Vulkan 1.3 takes no more than its bytes, rounded up to its own alignment
    for (const GpuBuffer* buffer : {&uploaded.vertices, &uploaded.indices, &uploaded.materials}) {
        VkMemoryRequirements needs;
        vkGetBufferMemoryRequirements(gpu.device.device, buffer->buffer, &needs);
        read += buffer->bytes;
        most += (buffer->bytes + needs.alignment - 1) / needs.alignment * needs.alignment;
    }
    EXPECT_GE(taken, read);
    EXPECT_LE(taken, most);
}

TEST_F(GpuSceneTest, AnEmptyLevelTakesNoMemory)
{
    const std::uint64_t before = gpu.memory.bytes();
    const GpuLevel level(gpu, uploadScene(gpu, Scene{}, {}, {}), GpuBaked{});
    EXPECT_EQ(gpu.memory.bytes(), before);
}

TEST_F(GpuSceneTest, MipsOfAnSrgbTextureAverageLight)
{
    // Two white and two black texels: the mean of their light is 1/2, which sRGB codes as 188 (0.5 coded alike would be 128).
    Scene scene;
    SceneTexture texture;
    texture.name = "checker";
    texture.srgb = true;
    texture.image.width = texture.image.height = 2;
    texture.image.pixels = {255, 255, 255, 255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255, 255};
    scene.textures.push_back(texture);
    const GpuScene uploaded = uploadScene(gpu, scene, {}, {});
    ASSERT_EQ(uploaded.textures.size(), 1u);
    EXPECT_NEAR(readback(gpu.memory, uploaded.textures[0], 1).at(0, 0)[0] * 255.0f, 188.0f, 1.5f);
}

TEST(RuntimeLights, AreThoseWhoseDirectPartTheBakeLacks)
{
    Scene scene;
    for (const uint bake : {kBakeIndirect, kBakeAll, kBakeNone}) {
        Light light = pointLight(vec3(0), vec3(1));
        light.bake = bake;
        addLight(scene, light);
    }
    addLight(scene, pointLight(vec3(0), vec3(0))); // gives no light
    EXPECT_EQ(runtimeLights(scene, /* baked */ false, false).size(), 3u);
    EXPECT_EQ(runtimeLights(scene, /* baked */ true, false).size(), 2u);
    EXPECT_EQ(runtimeLights(scene, /* baked */ true, /* directAll */ true).size(), 0u);
}
}
