// What the shaders of a pipeline ask to be given, by their reflection: descriptors and push constants, over all stages.
#include "engine/core/error.hpp"
#include "engine/gpu/pipeline.hpp"
#include <algorithm>

namespace afterglow
{
// Set 1 of all stages together; a binding that two stages share must agree.
static std::vector<ShaderBinding> mergeBindings(const std::vector<const Shader*>& stages)
{
    std::vector<ShaderBinding> merged;
    for (const Shader* stage : stages)
        for (const ShaderBinding& binding : stage->reflection.bindings) {
            if (binding.set > 1)
                throw Error("shader " + stage->path + " uses descriptor set " + std::to_string(binding.set) +
                            "; there are 0 (scene) and 1 (pass)");
            if (binding.set == 0) continue;
            const auto same = std::find_if(merged.begin(), merged.end(), [&](const auto& b) { return b.binding == binding.binding; });
            if (same == merged.end())
                merged.push_back(binding);
            else if (same->type != binding.type)
                throw Error("shader " + stage->path + " and its partner disagree about binding " + std::to_string(binding.binding));
        }
    return merged;
}

VkDescriptorSetLayout makeSetLayout(VkDevice device, const std::vector<VkDescriptorSetLayoutBinding>& bindings)
{
    const std::vector<VkDescriptorBindingFlags> flags(bindings.size(), VK_DESCRIPTOR_BINDING_PARTIALLY_BOUND_BIT);
    VkDescriptorSetLayoutBindingFlagsCreateInfo flagsInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_BINDING_FLAGS_CREATE_INFO};
    flagsInfo.bindingCount = static_cast<std::uint32_t>(flags.size());
    flagsInfo.pBindingFlags = flags.data();
    VkDescriptorSetLayoutCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    info.pNext = &flagsInfo;
    info.bindingCount = flagsInfo.bindingCount;
    info.pBindings = bindings.data();
    VkDescriptorSetLayout layout = VK_NULL_HANDLE;
    vk(vkCreateDescriptorSetLayout(device, &info, nullptr, &layout));
    return layout;
}

void Pipelines::makeLayout(Pipeline& pipeline, const std::vector<const Shader*>& stages, VkDescriptorSetLayout scene)
{
    VkShaderStageFlags all = 0;
    for (const Shader* stage : stages) {
        all |= stage->stage;
        if (stage->reflection.pushBytes) pipeline.pushStages |= stage->stage;
        pipeline.pushBytes = std::max(pipeline.pushBytes, stage->reflection.pushBytes);
        pipeline.name += (pipeline.name.empty() ? "" : " + ") + stage->path;
        std::copy_n(stage->reflection.groupSize, 3, pipeline.groupSize);
        for (const ShaderBinding& binding : stage->reflection.bindings)
            if (binding.set == 0 && !scene) throw Error("shader " + stage->path + " uses set 0, the scene, but no scene was given");
    }
    pipeline.bindings = mergeBindings(stages);
    if (pipeline.pushBytes > device.limits.maxPushConstantsSize)
        throw Error(pipeline.name + " has " + std::to_string(pipeline.pushBytes) + " bytes of push constants, this device takes " +
                    std::to_string(device.limits.maxPushConstantsSize));

    std::vector<VkDescriptorSetLayoutBinding> bindings;
    for (const ShaderBinding& binding : pipeline.bindings) bindings.push_back({binding.binding, binding.type, binding.count, all, nullptr});
    pipeline.resources = makeSetLayout(device.device, bindings);

    const VkDescriptorSetLayout sets[] = {scene ? scene : sceneLayout({}), pipeline.resources};
    // Vulkan wants push ranges in multiples of 4 bytes.
    const VkPushConstantRange push{pipeline.pushStages, 0, (pipeline.pushBytes + 3) / 4 * 4};
    VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    info.setLayoutCount = 2;
    info.pSetLayouts = sets;
    info.pushConstantRangeCount = pipeline.pushBytes ? 1 : 0;
    info.pPushConstantRanges = &push;
    vk(vkCreatePipelineLayout(device.device, &info, nullptr, &pipeline.layout));
}
}
