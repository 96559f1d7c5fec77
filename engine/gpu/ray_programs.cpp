// A pipeline of ray programs, and its shader binding table: where rays begin, what each kind of them meets in the void, and what at a
// surface.
#include "engine/core/error.hpp"
#include "engine/gpu/pipeline.hpp"
#include <algorithm>
#include <cstring>

namespace afterglow
{
using Group = VkRayTracingShaderGroupCreateInfoKHR;

static Group groupOf(VkRayTracingShaderGroupTypeKHR type)
{
    Group group{VK_STRUCTURE_TYPE_RAY_TRACING_SHADER_GROUP_CREATE_INFO_KHR};
    group.type = type;
    group.generalShader = group.closestHitShader = group.anyHitShader = group.intersectionShader = VK_SHADER_UNUSED_KHR;
    return group;
}

// First where rays begin, then the misses, then the hits.
static std::vector<Group> groupsOf(const PipelineKey& key, const std::vector<VkPipelineShaderStageCreateInfo>& stages)
{
    std::vector<Group> groups;
    for (std::uint32_t i = 0; i < stages.size(); ++i) {
        if (stages[i].stage != VK_SHADER_STAGE_RAYGEN_BIT_KHR && stages[i].stage != VK_SHADER_STAGE_MISS_BIT_KHR) continue;
        groups.push_back(groupOf(VK_RAY_TRACING_SHADER_GROUP_TYPE_GENERAL_KHR));
        groups.back().generalShader = i;
    }
    const auto placeOf = [&](const std::string& path) {
        const auto found = std::find(key.shaders.begin(), key.shaders.end(), path);
        return path.empty() ? VK_SHADER_UNUSED_KHR : static_cast<std::uint32_t>(found - key.shaders.begin());
    };
    for (const HitPrograms& hit : key.hits) {
        groups.push_back(groupOf(VK_RAY_TRACING_SHADER_GROUP_TYPE_TRIANGLES_HIT_GROUP_KHR));
        groups.back().closestHitShader = placeOf(hit.closest);
        groups.back().anyHitShader = placeOf(hit.any);
    }
    return groups;
}

static VkDeviceSize alignedTo(VkDeviceSize value, VkDeviceSize alignment) { return (value + alignment - 1) / alignment * alignment; }

static ShaderTable makeTable(Memory& memory, VkPipeline pipeline, std::uint32_t groups, std::uint32_t hits)
{
    const Device& device = memory.device;
    VkPhysicalDeviceRayTracingPipelinePropertiesKHR rules{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_TRACING_PIPELINE_PROPERTIES_KHR};
    VkPhysicalDeviceProperties2 all{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &rules, {}};
    vkGetPhysicalDeviceProperties2(device.physical, &all);
    std::vector<std::uint8_t> handles(std::size_t(groups) * rules.shaderGroupHandleSize);
    vk(device.shaderGroupHandles(device.device, pipeline, 0, groups, handles.size(), handles.data()));

    // Three regions, each from an aligned address on; memory may begin between two of them
    const VkDeviceSize stride = alignedTo(rules.shaderGroupHandleSize, rules.shaderGroupHandleAlignment);
    const std::uint32_t counts[] = {1, groups - 1 - hits, hits};
    VkDeviceSize bytes = rules.shaderGroupBaseAlignment;
    for (const std::uint32_t count : counts) bytes += alignedTo(count * stride, rules.shaderGroupBaseAlignment);
    ShaderTable table;
    table.buffer = memory.buffer("shader binding table", bytes, VK_BUFFER_USAGE_SHADER_BINDING_TABLE_BIT_KHR);
    std::vector<std::uint8_t> records(bytes);
    VkDeviceAddress at = alignedTo(table.buffer.address, rules.shaderGroupBaseAlignment);
    std::uint32_t group = 0;
    VkStridedDeviceAddressRegionKHR* const regions[] = {&table.begin, &table.misses, &table.hits};
    for (int r = 0; r < 3; ++r) {
        if (counts[r] > 0) *regions[r] = {at, stride, counts[r] * stride};
        for (std::uint32_t i = 0; i < counts[r]; ++i, ++group)
            std::memcpy(&records[at - table.buffer.address + i * stride], &handles[std::size_t(group) * rules.shaderGroupHandleSize],
                        rules.shaderGroupHandleSize);
        at = alignedTo(at + counts[r] * stride, rules.shaderGroupBaseAlignment);
    }
    memory.upload(table.buffer, records.data(), bytes);
    return table;
}

void makeRayPrograms(Memory& memory, VkPipelineCache cache, const PipelineKey& key,
                     const std::vector<VkPipelineShaderStageCreateInfo>& stages, Pipeline& pipeline)
{
    Device& device = memory.device;
    check(device.rayPipeline, pipeline.name + " are ray programs, and this device has no pipelines for them");
    const std::vector<Group> groups = groupsOf(key, stages);
    VkRayTracingPipelineCreateInfoKHR info{VK_STRUCTURE_TYPE_RAY_TRACING_PIPELINE_CREATE_INFO_KHR};
    info.stageCount = static_cast<std::uint32_t>(stages.size());
    info.pStages = stages.data();
    info.groupCount = static_cast<std::uint32_t>(groups.size());
    info.pGroups = groups.data();
    info.maxPipelineRayRecursionDepth = 1;
    info.layout = pipeline.layout;
    vk(device.createRayTracingPipelines(device.device, VK_NULL_HANDLE, cache, 1, &info, nullptr, &pipeline.pipeline));
    pipeline.table = makeTable(memory, pipeline.pipeline, info.groupCount, static_cast<std::uint32_t>(key.hits.size()));
}
}
