// GPU to core: a copy into a mapped buffer, then texel by texel into floats.
#include "engine/gpu/readback.hpp"
#include "engine/core/error.hpp"
#include "engine/gpu/transfer.hpp"
#include <cstring>

namespace afterglow
{
static GpuBuffer copyOut(Memory& memory, const GpuImage& image, std::uint32_t mip, std::uint32_t layer)
{
    const glm::uvec3 size = mipSize(image.shape, mip);
    const VkDeviceSize bytes = VkDeviceSize(size.x) * size.y * size.z * texelBytes(image.shape.format);
    GpuBuffer mapped = memory.buffer("readback", bytes, 0, Where::host);
    memory.device.submit([&](VkCommandBuffer commands) {
        const ImageRange range{mip, 1, layer, 1};
        changeLayout(commands, image, range, kRestLayout, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
        VkBufferImageCopy copy{};
        copy.imageSubresource = {aspectOf(image.shape.format), mip, layer, 1};
        copy.imageExtent = {size.x, size.y, size.z};
        vkCmdCopyImageToBuffer(commands, image.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, mapped.buffer, 1, &copy);
        changeLayout(commands, image, range, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, kRestLayout);
    });
    return mapped;
}

Image readback(Memory& memory, const GpuImage& image, std::uint32_t mip, std::uint32_t layer)
{
    const GpuBuffer mapped = copyOut(memory, image, mip, layer);
    const glm::uvec3 size = mipSize(image.shape, mip);
    const std::uint32_t channels = texelChannels(image.shape.format), bytes = texelBytes(image.shape.format);
    Image result(static_cast<int>(size.x), static_cast<int>(size.y * size.z), static_cast<int>(channels));
    const std::size_t texels = result.pixels.size() / channels;
    for (std::size_t i = 0; i < texels; ++i) unpackTexel(image.shape.format, mapped.mapped + i * bytes, &result.pixels[i * channels]);
    return result;
}

Image8 readback8(Memory& memory, const GpuImage& image)
{
    const VkFormat format = image.shape.format;
    check(format == VK_FORMAT_R8G8B8A8_UNORM || format == VK_FORMAT_R8G8B8A8_SRGB, image.name + " is not an RGBA8 image");
    const GpuBuffer mapped = copyOut(memory, image, 0, 0);
    Image8 result;
    result.width = static_cast<int>(image.shape.size.x);
    result.height = static_cast<int>(image.shape.size.y);
    result.pixels.assign(mapped.mapped, mapped.mapped + mapped.bytes);
    return result;
}

std::vector<std::uint8_t> readback(Memory& memory, const GpuBuffer& buffer)
{
    const GpuBuffer mapped = memory.buffer("readback", buffer.bytes, 0, Where::host);
    memory.device.submit([&](VkCommandBuffer commands) {
        const VkBufferCopy copy{0, 0, buffer.bytes};
        vkCmdCopyBuffer(commands, buffer.buffer, mapped.buffer, 1, &copy);
    });
    return {mapped.mapped, mapped.mapped + mapped.bytes};
}
}
