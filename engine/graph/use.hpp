// How a pass uses a texture or buffer, and what each use asks of Vulkan. A new use is a new line here and a new row of the table in
// use.cpp.
#pragma once
#include "engine/gpu/vk.hpp"

namespace afterglow
{
enum class Use {
    sampled,      // texture() and texelFetch() by a combined image sampler
    stored,       // imageStore; the old texels are not needed
    storedModify, // imageLoad and imageStore
    color,        // attachment: cleared or wholly overwritten
    colorModify,  // attachment: drawn on top of what is there
    depth,        // attachment: cleared, tested and written
    depthModify,  // attachment: tested and written on top of what is there
    depthTest,    // attachment: tested only
    bufferRead,   // storage or uniform buffer
    bufferWrite,
    bufferModify, // atomics, partial writes
    indirect,     // buffer: how many groups are dispatched
    copyFrom,
    copyTo
};

// The old content is needed; the content changes.
bool reads(Use use);
bool writes(Use use);
bool isColorUse(Use use);
bool isDepthUse(Use use);
bool isBinding(Use use); // takes the next binding of set 1

// What Vulkan is told of a use.
struct UseFacts {
    bool reads, writes;
    VkPipelineStageFlags2 stages; // 0: those of the pass's shaders
    VkAccessFlags2 access;
    VkImageLayout layout; // undefined: buffers have none
    VkImageUsageFlags imageUsage;
};
const UseFacts& factsOf(Use use);
}
