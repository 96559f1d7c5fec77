// Buffers: their making, moving and end.
#include "engine/gpu/memory.hpp"
#include <algorithm>
#include <utility>

namespace afterglow
{
GpuBuffer Memory::buffer(const std::string& name, VkDeviceSize bytes, VkBufferUsageFlags usage, Where where)
{
    VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    info.size = std::max<VkDeviceSize>(bytes, 4); // an empty buffer is still a buffer: zero lights are no special case
    info.usage = usage | VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT;
    GpuBuffer result;
    vk(vkCreateBuffer(device.device, &info, nullptr, &result.buffer));
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(device.device, result.buffer, &needs);
    result.allocation_ = allocate(needs, where, /* linear= */ true);
    result.owner_ = this;
    vk(vkBindBufferMemory(device.device, result.buffer, result.allocation_.memory, result.allocation_.offset));
    VkBufferDeviceAddressInfo address{VK_STRUCTURE_TYPE_BUFFER_DEVICE_ADDRESS_INFO};
    address.buffer = result.buffer;
    result.address = vkGetBufferDeviceAddress(device.device, &address);
    result.name = name;
    result.bytes = info.size;
    result.mapped = result.allocation_.mapped;
    device.name(VK_OBJECT_TYPE_BUFFER, reinterpret_cast<std::uint64_t>(result.buffer), name);
    ++made_;
    return result;
}

GpuBuffer& GpuBuffer::operator=(GpuBuffer&& other) noexcept
{
    std::swap(name, other.name);
    std::swap(buffer, other.buffer);
    std::swap(bytes, other.bytes);
    std::swap(address, other.address);
    std::swap(mapped, other.mapped);
    std::swap(owner_, other.owner_);
    std::swap(allocation_, other.allocation_);
    return *this;
}

GpuBuffer::~GpuBuffer()
{
    if (!owner_) return;
    vkDestroyBuffer(owner_->device.device, buffer, nullptr);
    owner_->free(allocation_);
}
}
