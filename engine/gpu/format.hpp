// What is known about the texel formats that we use, and their texels as floats.
#pragma once
#include "engine/gpu/vk.hpp"
#include <cstdint>

namespace afterglow
{
bool isDepth(VkFormat format);
std::uint32_t texelBytes(VkFormat format);    // check fails on formats we do not use
std::uint32_t texelChannels(VkFormat format); // as many as hold data: 3 for B10G11R11 and E5B9G9R9

// One texel as floats: unorm 0..1, snorm -1..1, half and packed formats unpacked, sRGB left encoded, integers as their value.
void unpackTexel(VkFormat format, const std::uint8_t* texel, float* channels);
}
