// Data into buffers and images by way of a staging buffer, and mips by blits.
#include "engine/gpu/transfer.hpp"
#include "engine/core/error.hpp"
#include <cstring>

namespace afterglow
{
void changeLayout(VkCommandBuffer commands, const GpuImage& image, const ImageRange& range, VkImageLayout from, VkImageLayout to)
{
    VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
    barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.oldLayout = from;
    barrier.newLayout = to;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image.image;
    const ImageRange r = resolve(range, image.shape);
    barrier.subresourceRange = {aspectOf(image.shape.format), r.mip, r.mips, r.layer, r.layers};
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
}

constexpr VkImageLayout kFrom = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
constexpr VkImageLayout kTo = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;

void Memory::clear(const GpuImage& image)
{
    device.submit([&](VkCommandBuffer commands) {
        changeLayout(commands, image, {}, VK_IMAGE_LAYOUT_UNDEFINED, kTo);
        const VkImageSubresourceRange all{aspectOf(image.shape.format), 0, image.shape.mips, 0, image.shape.layers};
        const VkClearColorValue zero{};
        const VkClearDepthStencilValue far{};
        if (isDepth(image.shape.format))
            vkCmdClearDepthStencilImage(commands, image.image, kTo, &far, 1, &all);
        else
            vkCmdClearColorImage(commands, image.image, kTo, &zero, 1, &all);
        changeLayout(commands, image, {}, kTo, kRestLayout);
    });
}

void Memory::upload(const GpuBuffer& buffer, const void* data, VkDeviceSize bytes, VkDeviceSize offset)
{
    check(offset + bytes <= buffer.bytes, "upload beyond the end of buffer " + buffer.name);
    if (!bytes) return;
    if (buffer.mapped) {
        std::memcpy(buffer.mapped + offset, data, bytes);
        return;
    }
    const GpuBuffer staging = this->buffer("staging", bytes, 0, Where::host);
    std::memcpy(staging.mapped, data, bytes);
    device.submit([&](VkCommandBuffer commands) {
        const VkBufferCopy copy{0, offset, bytes};
        vkCmdCopyBuffer(commands, staging.buffer, buffer.buffer, 1, &copy);
    });
}

void Memory::upload(const GpuImage& image, const void* data, VkDeviceSize bytes, std::uint32_t mip, std::uint32_t layer,
                    std::uint32_t layers)
{
    const ImageRange range = resolve({mip, 1, layer, layers}, image.shape);
    const glm::uvec3 size = mipSize(image.shape, mip);
    const std::uint64_t expected = std::uint64_t(size.x) * size.y * size.z * range.layers * texelBytes(image.shape.format);
    check(bytes == expected, "image " + image.name + ": the data has " + std::to_string(bytes) + " bytes, not " + std::to_string(expected));
    const GpuBuffer staging = buffer("staging", bytes, 0, Where::host);
    std::memcpy(staging.mapped, data, bytes);
    device.submit([&](VkCommandBuffer commands) {
        changeLayout(commands, image, range, kRestLayout, kTo);
        VkBufferImageCopy copy{};
        copy.imageSubresource = {aspectOf(image.shape.format), range.mip, range.layer, range.layers};
        copy.imageExtent = {size.x, size.y, size.z};
        vkCmdCopyBufferToImage(commands, staging.buffer, image.image, kTo, 1, &copy);
        changeLayout(commands, image, range, kTo, kRestLayout);
    });
}

void Memory::makeMips(const GpuImage& image)
{
    const ImageShape& shape = image.shape;
    device.submit([&](VkCommandBuffer commands) {
        for (std::uint32_t mip = 1; mip < shape.mips; ++mip) {
            const ImageRange from{mip - 1, 1, 0, 0}, to{mip, 1, 0, 0};
            changeLayout(commands, image, from, kRestLayout, kFrom);
            changeLayout(commands, image, to, kRestLayout, kTo);
            const glm::ivec3 a(mipSize(shape, mip - 1)), b(mipSize(shape, mip));
            VkImageBlit blit{};
            blit.srcSubresource = {aspectOf(shape.format), mip - 1, 0, shape.layers};
            blit.srcOffsets[1] = {a.x, a.y, a.z};
            blit.dstSubresource = {aspectOf(shape.format), mip, 0, shape.layers};
            blit.dstOffsets[1] = {b.x, b.y, b.z};
            vkCmdBlitImage(commands, image.image, kFrom, image.image, kTo, 1, &blit, VK_FILTER_LINEAR);
            changeLayout(commands, image, from, kFrom, kRestLayout);
            changeLayout(commands, image, to, kTo, kRestLayout);
        }
    });
}
}
