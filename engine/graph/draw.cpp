// Draws, counted.
#include "engine/graph/draw.hpp"
#include "engine/core/error.hpp"

namespace afterglow
{
void Draw::pushBytes(const void* data, std::size_t bytes)
{
    // A C++ struct may be padded at its end to its alignment, the block of the shader is not.
    check(bytes >= pipeline->pushBytes && bytes < pipeline->pushBytes + 8u, "pass " + pass + " pushes " + std::to_string(bytes) +
                                                                                " bytes, " + pipeline->name + " takes " +
                                                                                std::to_string(pipeline->pushBytes));
    if (pipeline->pushBytes) vkCmdPushConstants(commands, pipeline->layout, pipeline->pushStages, 0, pipeline->pushBytes, data);
}

void Draw::area(glm::uvec4 a)
{
    const VkViewport viewport{static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z), static_cast<float>(a.w), 0, 1};
    const VkRect2D scissor{{static_cast<std::int32_t>(a.x), static_cast<std::int32_t>(a.y)}, {a.z, a.w}};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &scissor);
}

void Draw::frontsOnly(bool only) { vkCmdSetCullMode(commands, only ? VK_CULL_MODE_BACK_BIT : VK_CULL_MODE_NONE); }

void Draw::clearDepth(glm::uvec4 a)
{
    const VkClearAttachment far_{VK_IMAGE_ASPECT_DEPTH_BIT, 0, {}};
    const VkClearRect rect{{{static_cast<std::int32_t>(a.x), static_cast<std::int32_t>(a.y)}, {a.z, a.w}}, 0, 1};
    vkCmdClearAttachments(commands, 1, &far_, 1, &rect);
}

void Draw::indices(const GpuBuffer& buffer) { vkCmdBindIndexBuffer(commands, buffer.buffer, 0, VK_INDEX_TYPE_UINT32); }

void Draw::count(std::uint64_t vertices, std::uint64_t instances)
{
    ++draws;
    triangles += vertices / 3 * instances;
}

void Draw::indexed(std::uint32_t n, std::uint32_t first, std::int32_t vertexOffset, std::uint32_t instances, std::uint32_t firstInstance)
{
    vkCmdDrawIndexed(commands, n, instances, first, vertexOffset, firstInstance);
    count(n, instances);
}

void Draw::vertices(std::uint32_t n, std::uint32_t instances, std::uint32_t first, std::uint32_t firstInstance)
{
    vkCmdDraw(commands, n, instances, first, firstInstance);
    count(n, instances);
}
}
