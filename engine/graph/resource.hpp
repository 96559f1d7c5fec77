// What passes hand to each other: handles of textures and buffers. A handle is a value; it holds no memory and no Vulkan object.
#pragma once
#include "engine/gpu/memory.hpp"
#include <cstdint>

namespace afterglow
{
constexpr std::uint32_t kNoResource = ~0u;

// A texture of the frame, or some of its mips and layers. An empty one (nothing made it) may be read: its binding number is kept and
// nothing is bound, so the shader must not touch it (a specialization constant decides).
struct Texture {
    std::uint32_t index = kNoResource; // into the graph's resources
    ImageShape shape;                  // of the whole texture
    ImageRange range;                  // the part that this handle speaks of; all zero: the whole
    ImageKind kind = ImageKind::flat;  // as what a shader sees that part

    explicit operator bool() const { return index != kNoResource; }
    VkFormat format() const { return shape.format; }
    glm::uvec2 size() const { return glm::uvec2(mipSize(shape, range.mip)); } // texels of its first mip
    std::uint32_t mips() const { return range.mips ? range.mips : shape.mips - range.mip; }
    std::uint32_t layers() const { return range.layers ? range.layers : shape.layers - range.layer; }

    Texture mip(std::uint32_t level) const;   // one mip, all layers of this handle
    Texture layer(std::uint32_t layer) const; // one layer (a face of a cube), seen as a flat image
};

struct Buffer {
    std::uint32_t index = kNoResource;
    VkDeviceSize bytes = 0;
    explicit operator bool() const { return index != kNoResource; }
};

// What outlives the frame: read what the last frame wrote (zero in the first), write what the next one reads.
struct History {
    Texture previous;
    Texture current;
};

// All clamped to the edge.
enum class Sampler {
    nearest, // the default, also for texelFetch
    linear,  // between mips too
    shadow   // sampler2DShadow: 1 where the reference depth >= the stored one (reversed depth: lit), four taps blended
};
}
