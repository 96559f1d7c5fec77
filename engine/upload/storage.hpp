// Values as a buffer on the GPU.
#pragma once
#include "engine/gpu/gpu.hpp"
#include <ranges>
#include <string>

namespace afterglow
{
// Absent when there are none.
template <std::ranges::contiguous_range Values>
GpuBuffer storage(Gpu& gpu, const std::string& name, const Values& values, VkBufferUsageFlags usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT)
{
    const std::size_t bytes = std::ranges::size(values) * sizeof(*std::ranges::data(values));
    if (bytes == 0) return {};
    GpuBuffer buffer = gpu.memory.buffer(name, bytes, usage);
    gpu.memory.upload(buffer, std::ranges::data(values), bytes);
    return buffer;
}
}
