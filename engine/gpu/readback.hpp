// From the GPU to core: images as floats whatever their format, buffers as bytes.
#pragma once
#include "engine/core/image.hpp"
#include "engine/gpu/memory.hpp"

namespace afterglow
{
// One mip of one layer as floats (unorm 0..1, half and packed formats unpacked, sRGB left encoded, integers as their value): as many
// channels as the format has, depth one. Row 0 is the top. A volume's slices follow each other downwards.
Image readback(Memory& memory, const GpuImage& image, std::uint32_t mip = 0, std::uint32_t layer = 0);

// The bytes of an RGBA8 image as they are, for writePng.
Image8 readback8(Memory& memory, const GpuImage& image);

std::vector<std::uint8_t> readback(Memory& memory, const GpuBuffer& buffer);
}
