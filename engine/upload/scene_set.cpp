#include "engine/upload/scene_set.hpp"
#include "engine/core/error.hpp"
#include <algorithm>

namespace afterglow
{
namespace
{
// What fills one binding of the set. An absent buffer or image leaves it unbound: no shader that the plan keeps touches it.
struct Binding {
    VkDescriptorType type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    std::vector<VkDescriptorBufferInfo> buffers;
    std::vector<VkDescriptorImageInfo> images;
    std::vector<VkAccelerationStructureKHR> structures;
    std::vector<VkBufferView> texels;
};

Binding binding(const GpuBuffer& buffer)
{
    Binding result;
    if (buffer) result.buffers.push_back({buffer.buffer, 0, VK_WHOLE_SIZE});
    return result;
}

Binding binding(const AccelerationStructure& structure)
{
    Binding result;
    result.type = VK_DESCRIPTOR_TYPE_ACCELERATION_STRUCTURE_KHR;
    result.structures.push_back(structure.structure);
    return result;
}

Binding binding(VkBufferView texels)
{
    Binding result;
    result.type = VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
    if (texels) result.texels.push_back(texels);
    return result;
}

Binding binding(const std::vector<const GpuImage*>& images, const std::vector<VkSampler>& samplers)
{
    Binding result;
    result.type = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    for (std::size_t i = 0; i < images.size(); ++i)
        if (*images[i]) result.images.push_back({samplers[i], images[i]->view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});
    return result;
}

std::vector<const GpuImage*> pointers(const std::vector<GpuImage>& images)
{
    std::vector<const GpuImage*> result;
    for (const GpuImage& image : images) result.push_back(&image);
    return result;
}

VkSamplerAddressMode addressMode(Wrap wrap)
{
    if (wrap == Wrap::repeat) return VK_SAMPLER_ADDRESS_MODE_REPEAT;
    return wrap == Wrap::mirror ? VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT : VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
}
}

VkSampler GpuLevel::sampler(const SceneTexture& how)
{
    const std::uint32_t key = std::uint32_t(how.wrapU) | std::uint32_t(how.wrapV) << 2 | std::uint32_t(how.nearest) << 4;
    for (const auto& [known, made] : samplers_)
        if (known == key) return made;
    VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    info.magFilter = info.minFilter = how.nearest ? VK_FILTER_NEAREST : VK_FILTER_LINEAR;
    info.mipmapMode = VK_SAMPLER_MIPMAP_MODE_LINEAR;
    info.addressModeU = addressMode(how.wrapU);
    info.addressModeV = addressMode(how.wrapV);
    info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    info.maxLod = VK_LOD_CLAMP_NONE;
    VkSampler made = VK_NULL_HANDLE;
    vk(vkCreateSampler(device_.device, &info, nullptr, &made));
    samplers_.emplace_back(key, made);
    return made;
}

// Of no buffer: none.
VkBufferView GpuLevel::view(const GpuBuffer& texels)
{
    if (!texels) return VK_NULL_HANDLE;
    VkBufferViewCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO};
    info.buffer = texels.buffer;
    info.format = VK_FORMAT_R32G32B32A32_SFLOAT;
    info.range = VK_WHOLE_SIZE;
    VkBufferView made = VK_NULL_HANDLE;
    vk(vkCreateBufferView(device_.device, &info, nullptr, &made));
    views_.push_back(made);
    return made;
}

GpuLevel::GpuLevel(Gpu& gpu, GpuScene scene_, GpuBaked baked_) : scene(std::move(scene_)), baked(std::move(baked_)), device_(gpu.device)
{
    std::vector<VkSampler> textureSamplers;
    for (const SceneTexture& how : scene.textureSamplers) textureSamplers.push_back(sampler(how));
    const auto clamped = [&](std::size_t count) {
        return std::vector<VkSampler>(count, sampler({.wrapU = Wrap::clamp, .wrapV = Wrap::clamp}));
    };
    std::vector<const GpuImage*> lightmaps = pointers(baked.lightmaps);
    for (const GpuImage& direction : baked.directions) lightmaps.push_back(&direction);
    // The order of shaders/bindings.glsl; two of them are declared by shaders/layer.h, and those of rays by shaders/trace.glsl
    std::vector<Binding> bindings = {
        binding(scene.vertices),
        binding(scene.materials),
        binding(scene.lights),
        binding(scene.media),
        binding(pointers(scene.textures), textureSamplers),
        binding({&scene.skyImage}, {sampler({.wrapU = Wrap::repeat, .wrapV = Wrap::clamp})}),
        binding(lightmaps, clamped(lightmaps.size())),
        binding(view(baked.probeTree)),
        binding(view(baked.probes)),
        binding(baked.probeStarts),
        binding(baked.reflectionBoxes),
        binding(pointers(baked.reflections), clamped(baked.reflections.size())),
        binding({&baked.splitSum}, clamped(1)),
        binding({&scene.layerRatio}, clamped(1)),
        binding({&scene.layerMean}, clamped(1)),
        binding(scene.mediumPlanes),
    };
    if (scene.rays) { // a device without rays does not know the kind
        bindings.push_back(binding(scene.rays.level));
        bindings.push_back(binding(scene.rays.triangles));
        bindings.push_back(binding(scene.rays.instances));
        bindings.push_back(binding(scene.rays.texels));
        bindings.push_back(binding(scene.rays.textures));
        bindings.push_back(binding(scene.rays.meetingErrors));
    }

    SetShape shape;
    std::vector<VkDescriptorPoolSize> sizes;
    for (const Binding& one : bindings) {
        const std::uint32_t count = std::max<std::uint32_t>(1, std::uint32_t(one.images.size()));
        shape.emplace_back(one.type, count);
        sizes.push_back({one.type, count});
    }
    set.layout = gpu.pipelines.sceneLayout(shape);

    VkDescriptorPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    poolInfo.maxSets = 1;
    poolInfo.poolSizeCount = std::uint32_t(sizes.size());
    poolInfo.pPoolSizes = sizes.data();
    vk(vkCreateDescriptorPool(device_.device, &poolInfo, nullptr, &pool_));
    VkDescriptorSetAllocateInfo allocate{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    allocate.descriptorPool = pool_;
    allocate.descriptorSetCount = 1;
    allocate.pSetLayouts = &set.layout;
    vk(vkAllocateDescriptorSets(device_.device, &allocate, &set.set));

    std::vector<VkWriteDescriptorSet> writes;
    std::vector<VkWriteDescriptorSetAccelerationStructureKHR> structures(bindings.size());
    for (std::uint32_t i = 0; i < bindings.size(); ++i) {
        const std::size_t count =
            bindings[i].buffers.size() + bindings[i].images.size() + bindings[i].structures.size() + bindings[i].texels.size();
        if (count == 0) continue;
        VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
        structures[i] = {VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET_ACCELERATION_STRUCTURE_KHR, nullptr,
                         std::uint32_t(bindings[i].structures.size()), bindings[i].structures.data()};
        if (!bindings[i].structures.empty()) write.pNext = &structures[i];
        write.dstSet = set.set;
        write.dstBinding = i;
        write.descriptorCount = std::uint32_t(count);
        write.descriptorType = bindings[i].type;
        write.pBufferInfo = bindings[i].buffers.data();
        write.pImageInfo = bindings[i].images.data();
        write.pTexelBufferView = bindings[i].texels.data();
        writes.push_back(write);
    }
    vkUpdateDescriptorSets(device_.device, std::uint32_t(writes.size()), writes.data(), 0, nullptr);
}

GpuLevel::~GpuLevel()
{
    for (const auto& [key, made] : samplers_) vkDestroySampler(device_.device, made, nullptr);
    for (VkBufferView made : views_) vkDestroyBufferView(device_.device, made, nullptr);
    if (pool_) vkDestroyDescriptorPool(device_.device, pool_, nullptr);
}
}
