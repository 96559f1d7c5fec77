// Inside of row 2: layout changes around one-off copies. Frames never need this: their barriers are derived in graph/barriers.cpp.
#pragma once
#include "engine/gpu/memory.hpp"

namespace afterglow
{
// Waits for everything before, makes everything visible after: for uploads and readback, whose submits are waited for anyway.
void changeLayout(VkCommandBuffer commands, const GpuImage& image, const ImageRange& range, VkImageLayout from, VkImageLayout to);
}
