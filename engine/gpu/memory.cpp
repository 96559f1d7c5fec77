// Blocks of device memory: first fit, neighbours merged when freed, empty blocks given back.
#include "engine/gpu/memory.hpp"
#include "engine/core/error.hpp"
#include <algorithm>
#include <map>

namespace afterglow
{
constexpr VkDeviceSize kBlockBytes = 64ull << 20; // one vkAllocateMemory; anything above half of it gets a block of its own

struct Memory::Block {
    VkDeviceMemory memory = VK_NULL_HANDLE;
    VkDeviceSize bytes = 0;
    std::uint32_t type = 0;
    Where where = Where::device; // one memory type may serve both; only one kind of block is mapped
    bool linear = false;         // buffers and images never share a block: no bufferImageGranularity to mind
    std::uint8_t* mapped = nullptr;
    std::map<VkDeviceSize, VkDeviceSize> holes; // offset -> bytes

    // The offset of a hole that fits, cut out of it; ~0 when there is none.
    VkDeviceSize take(VkDeviceSize size, VkDeviceSize alignment)
    {
        for (auto hole = holes.begin(); hole != holes.end(); ++hole) {
            const VkDeviceSize begin = (hole->first + alignment - 1) / alignment * alignment;
            const VkDeviceSize end = hole->first + hole->second;
            if (begin + size > end) continue;
            const VkDeviceSize before = begin - hole->first;
            if (begin + size < end) holes[begin + size] = end - begin - size;
            if (before)
                hole->second = before;
            else
                holes.erase(hole);
            return begin;
        }
        return ~VkDeviceSize(0);
    }

    void give(VkDeviceSize offset, VkDeviceSize size)
    {
        auto hole = holes.emplace(offset, size).first;
        const auto next = std::next(hole);
        if (next != holes.end() && hole->first + hole->second == next->first) {
            hole->second += next->second;
            holes.erase(next);
        }
        if (hole == holes.begin()) return;
        const auto previous = std::prev(hole);
        if (previous->first + previous->second != hole->first) return;
        previous->second += hole->second;
        holes.erase(hole);
    }
};

Memory::Memory(Device& d) : device(d) {}

Memory::~Memory()
{
    for (const auto& block : blocks_) check(!block, "a GPU buffer or image outlives the memory that it lies in");
}

static std::uint32_t pickType(VkPhysicalDevice physical, std::uint32_t bits, Where where)
{
    VkPhysicalDeviceMemoryProperties properties;
    vkGetPhysicalDeviceMemoryProperties(physical, &properties);
    const VkMemoryPropertyFlags local = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, cached = VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
    const VkMemoryPropertyFlags mapped = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    const VkMemoryPropertyFlags wanted[] = {where == Where::device ? local : mapped | cached, where == Where::device ? 0u : mapped};
    for (const VkMemoryPropertyFlags flags : wanted)
        for (std::uint32_t i = 0; i < properties.memoryTypeCount; ++i)
            if ((bits >> i & 1) && (properties.memoryTypes[i].propertyFlags & flags) == flags) return i;
    throw Error("the Vulkan device has no memory that fits; choose another with --device", Exit::noDevice);
}

Allocation Memory::allocate(const VkMemoryRequirements& needs, Where where, bool linear)
{
    const std::uint32_t type = pickType(device.physical, needs.memoryTypeBits, where);
    const bool alone = needs.size > kBlockBytes / 2;
    Allocation result;
    result.bytes = needs.size;
    const auto takeFrom = [&](std::uint32_t index) {
        Block& block = *blocks_[index];
        const VkDeviceSize offset = block.take(needs.size, needs.alignment);
        if (offset == ~VkDeviceSize(0)) return false;
        result.memory = block.memory;
        result.offset = offset;
        result.block = index;
        result.mapped = block.mapped ? block.mapped + offset : nullptr;
        used_ += needs.size;
        return true;
    };
    for (std::uint32_t i = 0; i < blocks_.size() && !alone; ++i)
        if (blocks_[i] && blocks_[i]->type == type && blocks_[i]->where == where && blocks_[i]->linear == linear && takeFrom(i))
            return result;

    auto block = std::make_unique<Block>();
    block->bytes = alone ? needs.size : kBlockBytes;
    block->type = type;
    block->where = where;
    block->linear = linear;
    block->holes[0] = block->bytes;
    VkMemoryAllocateFlagsInfo flags{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_FLAGS_INFO};
    flags.flags = VK_MEMORY_ALLOCATE_DEVICE_ADDRESS_BIT;
    VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
    info.pNext = linear ? &flags : nullptr;
    info.allocationSize = block->bytes;
    info.memoryTypeIndex = type;
    vk(vkAllocateMemory(device.device, &info, nullptr, &block->memory));
    if (where == Where::host) {
        void* mapped = nullptr;
        vk(vkMapMemory(device.device, block->memory, 0, VK_WHOLE_SIZE, 0, &mapped));
        block->mapped = static_cast<std::uint8_t*>(mapped);
    }
    reserved_ += block->bytes;

    const auto slot = std::find(blocks_.begin(), blocks_.end(), nullptr);
    const auto index = static_cast<std::uint32_t>(slot - blocks_.begin());
    if (slot == blocks_.end())
        blocks_.push_back(std::move(block));
    else
        *slot = std::move(block);
    check(takeFrom(index), "a fresh block holds what it was made for");
    return result;
}

void Memory::free(Allocation& allocation)
{
    Block& block = *blocks_[allocation.block];
    block.give(allocation.offset, allocation.bytes);
    used_ -= allocation.bytes;
    if (block.holes.begin()->second != block.bytes) return;
    vkFreeMemory(device.device, block.memory, nullptr);
    reserved_ -= block.bytes;
    blocks_[allocation.block].reset();
}
}
