// Command buffer, descriptor sets and timestamps of one frame after another: reset, not remade.
#include "engine/graph/frame_commands.hpp"
#include "engine/core/error.hpp"
#include <algorithm>

namespace afterglow
{
static VkSampler makeSampler(VkDevice device, Sampler kind)
{
    VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    info.magFilter = info.minFilter = kind == Sampler::nearest ? VK_FILTER_NEAREST : VK_FILTER_LINEAR;
    info.mipmapMode = kind == Sampler::linear ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST;
    info.addressModeU = info.addressModeV = info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    info.maxLod = VK_LOD_CLAMP_NONE;
    info.compareEnable = kind == Sampler::shadow;
    info.compareOp = VK_COMPARE_OP_GREATER_OR_EQUAL; // reversed depth: at least as near as the stored occluder is lit
    VkSampler sampler = VK_NULL_HANDLE;
    vk(vkCreateSampler(device, &info, nullptr, &sampler));
    return sampler;
}

FrameCommands::FrameCommands(Device& device) : device(device)
{
    VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    pool.queueFamilyIndex = device.queueFamily;
    vk(vkCreateCommandPool(device.device, &pool, nullptr, &pool_));
    VkCommandBufferAllocateInfo allocate{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    allocate.commandPool = pool_;
    allocate.commandBufferCount = 1;
    vk(vkAllocateCommandBuffers(device.device, &allocate, &commands));
    const VkFenceCreateInfo fence{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    vk(vkCreateFence(device.device, &fence, nullptr, &fence_));
    for (std::size_t i = 0; i < samplers_.size(); ++i) samplers_[i] = makeSampler(device.device, static_cast<Sampler>(i));
}

FrameCommands::~FrameCommands()
{
    for (VkSampler sampler : samplers_) vkDestroySampler(device.device, sampler, nullptr);
    for (VkDescriptorPool pool : descriptors_) vkDestroyDescriptorPool(device.device, pool, nullptr);
    vkDestroyQueryPool(device.device, queries_, nullptr);
    vkDestroyFence(device.device, fence_, nullptr);
    vkDestroyCommandPool(device.device, pool_, nullptr);
}

void FrameCommands::begin(std::size_t passes)
{
    vk(vkResetCommandPool(device.device, pool_, 0));
    for (VkDescriptorPool pool : descriptors_) vk(vkResetDescriptorPool(device.device, pool, 0));
    descriptorPool_ = 0;
    stamps_ = 0;
    const auto wanted = static_cast<std::uint32_t>(passes + 1);
    if (capacity_ < wanted) {
        vkDestroyQueryPool(device.device, queries_, nullptr);
        capacity_ = std::max(wanted, 64u);
        VkQueryPoolCreateInfo info{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
        info.queryType = VK_QUERY_TYPE_TIMESTAMP;
        info.queryCount = capacity_;
        vk(vkCreateQueryPool(device.device, &info, nullptr, &queries_));
    }
    vkResetQueryPool(device.device, queries_, 0, capacity_);
    VkCommandBufferBeginInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    vk(vkBeginCommandBuffer(commands, &info));
}

void FrameCommands::submit()
{
    vk(vkEndCommandBuffer(commands));
    VkCommandBufferSubmitInfo buffer{VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO};
    buffer.commandBuffer = commands;
    VkSubmitInfo2 info{VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
    info.commandBufferInfoCount = 1;
    info.pCommandBufferInfos = &buffer;
    vk(vkQueueSubmit2(device.queue, 1, &info, fence_));
    vk(vkWaitForFences(device.device, 1, &fence_, VK_TRUE, UINT64_MAX));
    vk(vkResetFences(device.device, 1, &fence_));
}

void FrameCommands::timestamp()
{
    if (device.timestampMilliseconds > 0) vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, queries_, stamps_++);
}

std::vector<double> FrameCommands::milliseconds() const
{
    if (stamps_ < 2) return {};
    std::vector<std::uint64_t> ticks(stamps_);
    vk(vkGetQueryPoolResults(device.device, queries_, 0, stamps_, ticks.size() * sizeof(ticks[0]), ticks.data(), sizeof(ticks[0]),
                             VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT));
    std::vector<double> result;
    for (std::size_t i = 1; i < ticks.size(); ++i)
        result.push_back(static_cast<double>(ticks[i] - ticks[i - 1]) * device.timestampMilliseconds);
    return result;
}

void FrameCommands::addPool()
{
    constexpr std::uint32_t kSets = 128;
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 8 * kSets},
                                          {VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, 4 * kSets},
                                          {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 4 * kSets},
                                          {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 2 * kSets}};
    VkDescriptorPoolCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    info.maxSets = kSets;
    info.poolSizeCount = static_cast<std::uint32_t>(std::size(sizes));
    info.pPoolSizes = sizes;
    vk(vkCreateDescriptorPool(device.device, &info, nullptr, &descriptors_.emplace_back()));
}

VkDescriptorSet FrameCommands::allocate(VkDescriptorSetLayout layout)
{
    for (;; ++descriptorPool_) {
        const bool fresh = descriptorPool_ == descriptors_.size();
        if (fresh) addPool();
        VkDescriptorSetAllocateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
        info.descriptorPool = descriptors_[descriptorPool_];
        info.descriptorSetCount = 1;
        info.pSetLayouts = &layout;
        VkDescriptorSet set = VK_NULL_HANDLE;
        const VkResult result = vkAllocateDescriptorSets(device.device, &info, &set);
        if (result == VK_SUCCESS) return set;
        if (fresh || result != VK_ERROR_OUT_OF_POOL_MEMORY) checkVulkan("vkAllocateDescriptorSets", result);
    }
}

static bool agrees(const Access& access, VkDescriptorType type)
{
    switch (access.use) {
    case Use::sampled:
        return type == VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    case Use::stored:
    case Use::storedModify:
        return type == VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    case Use::bufferRead:
        return type == VK_DESCRIPTOR_TYPE_STORAGE_BUFFER || type == VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    default:
        return type == VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    }
}

VkDescriptorSet FrameCommands::bind(const Pipeline& pipeline, const PassData& pass, const Graph& graph, const Schedule& schedule,
                                    const Objects& objects)
{
    std::vector<const Access*> wanted;
    for (const Access& access : pass.accesses)
        if (isBinding(access.use)) wanted.push_back(&access);
    std::vector<VkDescriptorImageInfo> images(wanted.size());
    std::vector<VkDescriptorBufferInfo> buffers(wanted.size());
    std::vector<VkWriteDescriptorSet> written;
    const VkDescriptorSet set = allocate(pipeline.resources);
    for (const ShaderBinding& binding : pipeline.bindings) {
        const std::string where = "pass " + pass.name + ": binding " + std::to_string(binding.binding) + " of " + pipeline.name;
        if (binding.binding >= wanted.size())
            throw Error(where + " is given nothing: the pass declares " + std::to_string(wanted.size()) + " reads and writes");
        const Access& access = *wanted[binding.binding];
        if (access.resource == kNoResource) continue;
        const Resource& resource = graph.resources[access.resource];
        if (!agrees(access, binding.type) || binding.count != 1)
            throw Error(where + " is not of the kind that the pass gives it: " + resource.name);
        const std::uint32_t physical = schedule.physicalOf[access.resource];
        VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
        write.dstSet = set;
        write.dstBinding = binding.binding;
        write.descriptorCount = 1;
        write.descriptorType = binding.type;
        if (resource.isBuffer) {
            buffers[binding.binding] = {objects.buffers[physical]->buffer, 0, std::max<VkDeviceSize>(resource.bytes, 4)};
            write.pBufferInfo = &buffers[binding.binding];
        } else {
            images[binding.binding] = {samplers_[static_cast<std::size_t>(access.sampler)],
                                       objects.images[physical]->viewOf(access.range, access.kind), layoutOf(pass, access)};
            write.pImageInfo = &images[binding.binding];
        }
        written.push_back(write);
    }
    for (std::size_t i = 0; i < wanted.size(); ++i)
        if (std::none_of(pipeline.bindings.begin(), pipeline.bindings.end(), [&](const auto& b) { return b.binding == i; }))
            throw Error("pass " + pass.name + " declares something for binding " + std::to_string(i) + ", which " + pipeline.name +
                        " does not have");
    vkUpdateDescriptorSets(device.device, static_cast<std::uint32_t>(written.size()), written.data(), 0, nullptr);
    return set;
}
}
