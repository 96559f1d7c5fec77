// Images: their shapes in numbers, their making, their views.
#include "engine/core/error.hpp"
#include "engine/gpu/memory.hpp"
#include <algorithm>
#include <bit>
#include <utility>

namespace afterglow
{
std::uint32_t mipCount(glm::uvec2 size) { return static_cast<std::uint32_t>(std::bit_width(std::max(size.x, size.y))); }

glm::uvec3 mipSize(const ImageShape& shape, std::uint32_t mip)
{
    const auto half = [&](std::uint32_t n) { return std::max(n >> mip, 1u); };
    return {half(shape.size.x), half(shape.size.y), half(shape.size.z)};
}

std::uint64_t imageBytes(const ImageShape& shape)
{
    std::uint64_t texels = 0;
    for (std::uint32_t mip = 0; mip < shape.mips; ++mip) {
        const glm::uvec3 size = mipSize(shape, mip);
        texels += std::uint64_t(size.x) * size.y * size.z;
    }
    return texels * shape.layers * texelBytes(shape.format);
}

ImageRange whole(const ImageShape& shape) { return {0, shape.mips, 0, shape.layers}; }

ImageRange resolve(const ImageRange& range, const ImageShape& shape)
{
    ImageRange result = range;
    if (!result.mips) result.mips = shape.mips - result.mip;
    if (!result.layers) result.layers = shape.layers - result.layer;
    return result;
}

VkImageAspectFlags aspectOf(VkFormat format) { return isDepth(format) ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT; }

static VkImageViewType viewType(ImageKind kind, std::uint32_t layers)
{
    switch (kind) {
    case ImageKind::array:
        return VK_IMAGE_VIEW_TYPE_2D_ARRAY;
    case ImageKind::cube:
        return layers > 6 ? VK_IMAGE_VIEW_TYPE_CUBE_ARRAY : VK_IMAGE_VIEW_TYPE_CUBE;
    case ImageKind::volume:
        return VK_IMAGE_VIEW_TYPE_3D;
    default:
        return VK_IMAGE_VIEW_TYPE_2D;
    }
}

GpuImage Memory::image(const std::string& name, const ImageShape& shape, VkImageUsageFlags usage)
{
    check(shape.size.x && shape.size.y && shape.size.z && shape.mips && shape.layers, "image " + name + " has no texels");
    check(shape.kind != ImageKind::cube || (shape.size.x == shape.size.y && shape.layers % 6 == 0), "cube " + name + " is no cube");
    VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    if (shape.kind == ImageKind::cube) info.flags = VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT;
    info.imageType = shape.kind == ImageKind::volume ? VK_IMAGE_TYPE_3D : VK_IMAGE_TYPE_2D;
    info.format = shape.format;
    info.extent = {shape.size.x, shape.size.y, shape.size.z};
    info.mipLevels = shape.mips;
    info.arrayLayers = shape.layers;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = usage | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    GpuImage result;
    vk(vkCreateImage(device.device, &info, nullptr, &result.image));
    VkMemoryRequirements needs;
    vkGetImageMemoryRequirements(device.device, result.image, &needs);
    result.allocation_ = allocate(needs, Where::device, /* linear= */ false);
    result.owner_ = this;
    vk(vkBindImageMemory(device.device, result.image, result.allocation_.memory, result.allocation_.offset));
    result.name = name;
    result.shape = shape;
    result.usage = info.usage;
    device.name(VK_OBJECT_TYPE_IMAGE, reinterpret_cast<std::uint64_t>(result.image), name);
    result.view = result.viewOf(whole(shape), shape.kind);
    ++made_;
    clear(result);
    return result;
}

VkImageView GpuImage::viewOf(const ImageRange& wanted, ImageKind kind) const
{
    const ImageRange range = resolve(wanted, shape);
    for (const View& known : views_)
        if (known.range == range && known.kind == kind) return known.view;
    VkImageViewCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    info.image = image;
    info.viewType = viewType(kind, range.layers);
    info.format = shape.format;
    info.subresourceRange = {aspectOf(shape.format), range.mip, range.mips, range.layer, range.layers};
    VkImageView made = VK_NULL_HANDLE;
    vk(vkCreateImageView(owner_->device.device, &info, nullptr, &made));
    views_.push_back({range, kind, made});
    return made;
}

GpuImage& GpuImage::operator=(GpuImage&& other) noexcept
{
    std::swap(name, other.name);
    std::swap(image, other.image);
    std::swap(view, other.view);
    std::swap(shape, other.shape);
    std::swap(usage, other.usage);
    std::swap(owner_, other.owner_);
    std::swap(allocation_, other.allocation_);
    std::swap(views_, other.views_);
    return *this;
}

GpuImage::~GpuImage()
{
    if (!owner_) return;
    for (const View& known : views_) vkDestroyImageView(owner_->device.device, known.view, nullptr);
    vkDestroyImage(owner_->device.device, image, nullptr);
    owner_->free(allocation_);
}
}
