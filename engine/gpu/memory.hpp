// The one way to allocate GPU memory: buffers and images carved from 64 MiB blocks, freed by their destructors, every byte counted.
#pragma once
#include "engine/gpu/device.hpp"
#include "engine/gpu/format.hpp"
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

namespace afterglow
{
class Memory;

// A range of one block. Owned by a buffer or an image.
struct Allocation {
    VkDeviceMemory memory = VK_NULL_HANDLE;
    VkDeviceSize offset = 0;
    VkDeviceSize bytes = 0;
    std::uint32_t block = 0;
    std::uint8_t* mapped = nullptr; // null unless the host sees it
};

enum class Where {
    device, // fast for the GPU; filled by Memory::upload
    host    // mapped and coherent: small data rewritten every frame, readback
};

// Every buffer has a device address (its usage gets SHADER_DEVICE_ADDRESS and TRANSFER_DST/SRC by itself).
class GpuBuffer
{
public:
    GpuBuffer() = default;
    GpuBuffer(GpuBuffer&& other) noexcept { *this = std::move(other); }
    GpuBuffer& operator=(GpuBuffer&& other) noexcept;
    ~GpuBuffer();
    explicit operator bool() const { return buffer != VK_NULL_HANDLE; }

    std::string name;
    VkBuffer buffer = VK_NULL_HANDLE;
    VkDeviceSize bytes = 0;
    VkDeviceAddress address = 0;
    std::uint8_t* mapped = nullptr; // Where::host only

private:
    friend class Memory;
    Memory* owner_ = nullptr;
    Allocation allocation_;
};

enum class ImageKind {
    flat,  // sampler2D
    array, // sampler2DArray, even of one layer
    cube,  // samplerCube; samplerCubeArray when there are more than 6 layers
    volume // sampler3D
};

struct ImageShape {
    VkFormat format = VK_FORMAT_UNDEFINED;
    glm::uvec3 size{1, 1, 1};
    std::uint32_t mips = 1;
    std::uint32_t layers = 1; // a cube has 6
    ImageKind kind = ImageKind::flat;
    bool operator==(const ImageShape&) const = default;
};

std::uint64_t imageBytes(const ImageShape& shape);
std::uint32_t mipCount(glm::uvec2 size); // down to 1x1
glm::uvec3 mipSize(const ImageShape& shape, std::uint32_t mip);

// Some of an image's mips and layers; a count of 0 means all that follow.
struct ImageRange {
    std::uint32_t mip = 0, mips = 0, layer = 0, layers = 0;
    bool operator==(const ImageRange&) const = default;
};
ImageRange whole(const ImageShape& shape);
ImageRange resolve(const ImageRange& range, const ImageShape& shape); // with counts in place of zeros
VkImageAspectFlags aspectOf(VkFormat format);

// Between frames every image rests in this layout, where anybody may sample it.
constexpr VkImageLayout kRestLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;

class GpuImage
{
public:
    GpuImage() = default;
    GpuImage(GpuImage&& other) noexcept { *this = std::move(other); }
    GpuImage& operator=(GpuImage&& other) noexcept;
    ~GpuImage();
    explicit operator bool() const { return image != VK_NULL_HANDLE; }

    // The view of some mips and layers, made once. `kind`: as what the shader sees it (a layer of an array as flat, say).
    VkImageView viewOf(const ImageRange& range, ImageKind kind) const;

    std::string name;
    VkImage image = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE; // all of it, as its kind
    ImageShape shape;
    VkImageUsageFlags usage = 0;

private:
    friend class Memory;
    struct View {
        ImageRange range;
        ImageKind kind;
        VkImageView view;
    };
    Memory* owner_ = nullptr;
    Allocation allocation_;
    mutable std::vector<View> views_;
};

class Memory
{
public:
    explicit Memory(Device& device);
    ~Memory();
    Memory(const Memory&) = delete;
    Memory& operator=(const Memory&) = delete;

    GpuBuffer buffer(const std::string& name, VkDeviceSize bytes, VkBufferUsageFlags usage, Where where = Where::device);
    // Zero everywhere and at rest from the start: nothing ever reads undefined memory. SAMPLED and TRANSFER_SRC/DST come by themselves.
    GpuImage image(const std::string& name, const ImageShape& shape, VkImageUsageFlags usage = 0);

    // Staged; returns when the data is there. Image data is tightly packed, layer after layer of one mip; a count of 0: all layers.
    void upload(const GpuBuffer& buffer, const void* data, VkDeviceSize bytes, VkDeviceSize offset = 0);
    void upload(const GpuImage& image, const void* data, VkDeviceSize bytes, std::uint32_t mip = 0, std::uint32_t layer = 0,
                std::uint32_t layers = 0);
    // Fills mips 1.. of every layer from mip 0 by repeated 2x2 averages (linear blits).
    void makeMips(const GpuImage& image);

    std::uint64_t bytes() const { return used_; }        // in living buffers and images
    std::uint64_t reserved() const { return reserved_; } // taken from the device
    std::uint32_t allocations() const { return made_; }  // buffers and images made since the start: equal before and after a steady frame

    Device& device;

private:
    friend class GpuBuffer;
    friend class GpuImage;
    struct Block;
    Allocation allocate(const VkMemoryRequirements& needs, Where where, bool linear);
    void free(Allocation& allocation);
    void clear(const GpuImage& image);
    std::vector<std::unique_ptr<Block>> blocks_;
    std::uint64_t used_ = 0, reserved_ = 0;
    std::uint32_t made_ = 0;
};
}
