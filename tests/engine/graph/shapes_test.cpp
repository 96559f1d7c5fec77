// Volumes, cubes, the scene's set 0, indexed draws.
#include "engine/graph/draw.hpp"
#include "tests/engine/graph/running.hpp"

namespace afterglow
{
using ShapesTest = Running;

TEST_F(ShapesTest, VolumesAreStoredAndFiltered)
{
    Graph graph;
    const Texture volume = graph.texture("volume", {VK_FORMAT_R32_SFLOAT, {6, 5, 7}, 1, 1, ImageKind::volume}),
                  out = graph.texture("out", kFloat, {4, 4});
    graph.compute("slices", kShaders + "slices.comp").write(volume).dispatch(volume.shape.size);
    graph.fullscreen("volume", kShaders + "volume.frag").read(volume, Sampler::linear).write(out);
    graph.output(out);
    executor.run(graph);
    for (const float value : executor.download(out).pixels) EXPECT_NEAR(value, 0.5f, 1e-5f);
}

TEST_F(ShapesTest, FacesAreDrawnAndTheCubeIsLookedInto)
{
    Graph graph;
    const Texture cube = graph.texture("cube", {kFloat, {4, 4, 1}, 1, 6, ImageKind::cube}), out = graph.texture("out", kFloat, {6, 1});
    for (std::uint32_t face = 0; face < 6; ++face)
        graph.fullscreen("face " + std::to_string(face), kShaders + "constant.frag").write(cube.layer(face)).push(static_cast<float>(face));
    graph.fullscreen("look", kShaders + "cube.frag").read(cube, Sampler::linear).write(out);
    graph.output(out);
    executor.run(graph);
    for (int face = 0; face < 6; ++face) EXPECT_EQ(executor.download(out).at(face, 0)[0], static_cast<float>(face));
}

TEST_F(ShapesTest, TheSceneIsSetZeroOfEveryPass)
{
    // Two numbers and two textures; what the upload layer does at scale.
    const VkDevice device = gpu.device.device;
    const GpuBuffer numbers = gpu.memory.buffer("numbers", 8, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    const float values[] = {10, 20};
    gpu.memory.upload(numbers, values, sizeof(values));
    GpuImage images[2];
    for (int i = 0; i < 2; ++i) {
        images[i] = gpu.memory.image("texture", {VK_FORMAT_R32_SFLOAT, {1, 1, 1}});
        const float texel = static_cast<float>(i + 1);
        gpu.memory.upload(images[i], &texel, sizeof(texel));
    }
    const VkSamplerCreateInfo samplerInfo{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    VkSampler sampler = VK_NULL_HANDLE;
    vk(vkCreateSampler(device, &samplerInfo, nullptr, &sampler));
    SceneSet scene;
    scene.layout = gpu.pipelines.sceneLayout({{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1}, {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 2}});
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1}, {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 2}};
    VkDescriptorPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    poolInfo.maxSets = 1;
    poolInfo.poolSizeCount = 2;
    poolInfo.pPoolSizes = sizes;
    VkDescriptorPool pool = VK_NULL_HANDLE;
    vk(vkCreateDescriptorPool(device, &poolInfo, nullptr, &pool));
    VkDescriptorSetAllocateInfo allocate{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    allocate.descriptorPool = pool;
    allocate.descriptorSetCount = 1;
    allocate.pSetLayouts = &scene.layout;
    vk(vkAllocateDescriptorSets(device, &allocate, &scene.set));
    const VkDescriptorBufferInfo buffer{numbers.buffer, 0, VK_WHOLE_SIZE};
    const VkDescriptorImageInfo textures[] = {{sampler, images[0].view, kRestLayout}, {sampler, images[1].view, kRestLayout}};
    VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = scene.set;
    write.descriptorCount = 1;
    write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    write.pBufferInfo = &buffer;
    vkUpdateDescriptorSets(device, 1, &write, 0, nullptr);
    write.dstBinding = 1;
    write.descriptorCount = 2;
    write.descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    write.pImageInfo = textures;
    vkUpdateDescriptorSets(device, 1, &write, 0, nullptr);

    Graph graph;
    Texture out[2];
    for (std::uint32_t i = 0; i < 2; ++i) {
        out[i] = graph.texture("out", kFloat, {2, 2});
        graph.fullscreen("scene", kShaders + "scene.frag").write(out[i]).push(i);
        graph.output(out[i]);
    }
    executor.run(graph, scene);
    EXPECT_EQ(executor.download(out[0]).at(0, 0)[0], 11.0f);
    EXPECT_EQ(executor.download(out[1]).at(0, 0)[0], 22.0f);
    vkDestroyDescriptorPool(device, pool, nullptr);
    vkDestroySampler(device, sampler, nullptr);
}

TEST_F(ShapesTest, IndicesCountFromTheVertexOffset)
{
    // Two triangles, the second covers the picture; the indices with their offset pick it.
    const std::vector<glm::vec3> vertices = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {-1, -1, 0}, {-1, 3, 0}, {3, -1, 0}};
    const std::vector<std::uint32_t> order = {0, 1, 2};
    const GpuBuffer indices = gpu.memory.buffer("indices", 12, VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
    gpu.memory.upload(indices, order.data(), 12);
    Graph graph;
    const Texture color = graph.texture("color", kFloat, {4, 4});
    graph.raster("draw", kShaders + "triangles.vert", kShaders + "number.frag")
        .read(graph.upload("vertices", std::span<const glm::vec3>(vertices)))
        .write(color)
        .push(1.0f)
        .draw([&](Draw& draw) {
            draw.indices(indices);
            draw.indexed(3, 0, 3);
        });
    graph.output(color);
    EXPECT_EQ(executor.run(graph).draws, 1u);
    EXPECT_EQ(executor.download(color).at(2, 2)[0], 2.0f); // gl_VertexIndex counts from the vertex offset
}
}
