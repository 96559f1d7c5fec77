// Texels as floats.
#include "engine/gpu/format.hpp"
#include <cstring>
#include <gtest/gtest.h>

namespace afterglow
{
template <typename T>
static float first(VkFormat format, T bits, std::uint32_t channel = 0)
{
    float channels[4] = {};
    std::uint8_t texel[16] = {};
    std::memcpy(texel, &bits, sizeof(bits));
    unpackTexel(format, texel, channels);
    return channels[channel];
}

TEST(Format, TexelsUnpackByTheirDefinition)
{
    EXPECT_FLOAT_EQ(first(VK_FORMAT_R8_UNORM, std::uint8_t(255)), 1.0f);
    EXPECT_FLOAT_EQ(first(VK_FORMAT_R8_UNORM, std::uint8_t(51)), 0.2f);
    EXPECT_FLOAT_EQ(first(VK_FORMAT_R8G8_SNORM, std::uint16_t(0x7f81), 0), -1.0f); // 0x81 = -127
    EXPECT_FLOAT_EQ(first(VK_FORMAT_R16_SFLOAT, std::uint16_t(0x3c00)), 1.0f);     // half: sign 0, exponent 15, mantissa 0
    EXPECT_FLOAT_EQ(first(VK_FORMAT_R16_UINT, std::uint16_t(4711)), 4711.0f);
    EXPECT_FLOAT_EQ(first(VK_FORMAT_D32_SFLOAT, 0.25f), 0.25f);
    EXPECT_FLOAT_EQ(first(VK_FORMAT_B8G8R8A8_UNORM, 0x000000ffu, 2), 1.0f); // the lowest byte is blue
    EXPECT_FLOAT_EQ(first(VK_FORMAT_A2B10G10R10_UNORM_PACK32, 0x3ffu), 1.0f);
    // B10G11R11: red is the lowest 11 bits, exponent 15 in 5 bits above 6 of mantissa.
    EXPECT_FLOAT_EQ(first(VK_FORMAT_B10G11R11_UFLOAT_PACK32, 15u << 6), 1.0f);
    // Its largest finite values: every mantissa bit under exponent 30, 63/64 or 31/32 of a step below 2^16.
    EXPECT_EQ(first(VK_FORMAT_B10G11R11_UFLOAT_PACK32, 30u << 6 | 63u), 65024.0f);
    EXPECT_EQ(first(VK_FORMAT_B10G11R11_UFLOAT_PACK32, (30u << 6 | 63u) << 11, 1), 65024.0f);
    EXPECT_EQ(first(VK_FORMAT_B10G11R11_UFLOAT_PACK32, (30u << 5 | 31u) << 22, 2), 64512.0f);
    // E5B9G9R9: mantissa 256 of 512, exponent 16 - 15: 0.5 * 2.
    EXPECT_FLOAT_EQ(first(VK_FORMAT_E5B9G9R9_UFLOAT_PACK32, 16u << 27 | 256u), 1.0f);
    EXPECT_EQ(first(VK_FORMAT_E5B9G9R9_UFLOAT_PACK32, 0xffffffffu), 65408.0f);
}

TEST(Format, ChannelsTimesTheirBytesAreTheTexel)
{
    EXPECT_EQ(texelBytes(VK_FORMAT_R16G16B16A16_SFLOAT), 8u);
    EXPECT_EQ(texelChannels(VK_FORMAT_R16G16B16A16_SFLOAT), 4u);
    EXPECT_EQ(texelChannels(VK_FORMAT_E5B9G9R9_UFLOAT_PACK32), 3u);
    EXPECT_TRUE(isDepth(VK_FORMAT_D32_SFLOAT));
    EXPECT_FALSE(isDepth(VK_FORMAT_R32_SFLOAT));
}
}
