// The table of formats.
#include "engine/gpu/format.hpp"
#include "engine/core/error.hpp"
#include <cstring>
#include <glm/glm.hpp>
#include <glm/gtc/packing.hpp>
#include <string>

namespace afterglow
{
enum class Texel { unorm8, snorm8, uint8, uint16, unorm16, snorm16, half, uint32, float32, b10g11r11, e5b9g9r9, a2b10g10r10, bgra8 };

struct FormatFacts {
    VkFormat format;
    std::uint32_t bytes, channels;
    Texel texel;
};

static constexpr FormatFacts kFormats[] = {
    {VK_FORMAT_R8_UNORM, 1, 1, Texel::unorm8},
    {VK_FORMAT_R8G8_UNORM, 2, 2, Texel::unorm8},
    {VK_FORMAT_R8G8_SNORM, 2, 2, Texel::snorm8},
    {VK_FORMAT_R8G8B8A8_UNORM, 4, 4, Texel::unorm8},
    {VK_FORMAT_R8G8B8A8_SNORM, 4, 4, Texel::snorm8},
    {VK_FORMAT_R8G8B8A8_SRGB, 4, 4, Texel::unorm8},
    {VK_FORMAT_B8G8R8A8_UNORM, 4, 4, Texel::bgra8},
    {VK_FORMAT_B8G8R8A8_SRGB, 4, 4, Texel::bgra8},
    {VK_FORMAT_R8_UINT, 1, 1, Texel::uint8},
    {VK_FORMAT_R16_UINT, 2, 1, Texel::uint16},
    {VK_FORMAT_R16G16_UINT, 4, 2, Texel::uint16},
    {VK_FORMAT_R16_UNORM, 2, 1, Texel::unorm16},
    {VK_FORMAT_R16G16_UNORM, 4, 2, Texel::unorm16},
    {VK_FORMAT_R16G16_SNORM, 4, 2, Texel::snorm16},
    {VK_FORMAT_R16G16B16A16_UNORM, 8, 4, Texel::unorm16},
    {VK_FORMAT_R16_SFLOAT, 2, 1, Texel::half},
    {VK_FORMAT_R16G16_SFLOAT, 4, 2, Texel::half},
    {VK_FORMAT_R16G16B16A16_SFLOAT, 8, 4, Texel::half},
    {VK_FORMAT_R32_UINT, 4, 1, Texel::uint32},
    {VK_FORMAT_R32G32_UINT, 8, 2, Texel::uint32},
    {VK_FORMAT_R32G32B32A32_UINT, 16, 4, Texel::uint32},
    {VK_FORMAT_R32_SFLOAT, 4, 1, Texel::float32},
    {VK_FORMAT_R32G32_SFLOAT, 8, 2, Texel::float32},
    {VK_FORMAT_R32G32B32A32_SFLOAT, 16, 4, Texel::float32},
    {VK_FORMAT_D32_SFLOAT, 4, 1, Texel::float32},
    {VK_FORMAT_D16_UNORM, 2, 1, Texel::unorm16},
    {VK_FORMAT_B10G11R11_UFLOAT_PACK32, 4, 3, Texel::b10g11r11},
    {VK_FORMAT_E5B9G9R9_UFLOAT_PACK32, 4, 3, Texel::e5b9g9r9},
    {VK_FORMAT_A2B10G10R10_UNORM_PACK32, 4, 4, Texel::a2b10g10r10},
};

static const FormatFacts& facts(VkFormat format)
{
    for (const FormatFacts& entry : kFormats)
        if (entry.format == format) return entry;
    check(false, "format " + std::to_string(format) + " is not in the table of engine/gpu/format.cpp");
    return kFormats[0];
}

bool isDepth(VkFormat format) { return format == VK_FORMAT_D32_SFLOAT || format == VK_FORMAT_D16_UNORM; }
std::uint32_t texelBytes(VkFormat format) { return facts(format).bytes; }
std::uint32_t texelChannels(VkFormat format) { return facts(format).channels; }

template <typename T>
static T load(const std::uint8_t* from, std::uint32_t channel)
{
    T value;
    std::memcpy(&value, from + channel * sizeof(T), sizeof(T));
    return value;
}

void unpackTexel(VkFormat format, const std::uint8_t* texel, float* channels)
{
    const FormatFacts& f = facts(format);
    const auto copy = [&](const auto& v) {
        for (std::uint32_t c = 0; c < f.channels; ++c) channels[c] = v[static_cast<int>(c)];
    };
    switch (f.texel) {
    case Texel::b10g11r11:
        return copy(glm::unpackF2x11_1x10(load<std::uint32_t>(texel, 0)));
    case Texel::e5b9g9r9:
        return copy(glm::unpackF3x9_E1x5(load<std::uint32_t>(texel, 0)));
    case Texel::a2b10g10r10:
        return copy(glm::unpackUnorm3x10_1x2(load<std::uint32_t>(texel, 0)));
    case Texel::bgra8: {
        const glm::vec4 v = glm::unpackUnorm4x8(load<std::uint32_t>(texel, 0));
        return copy(glm::vec4(v.z, v.y, v.x, v.w));
    }
    default:
        break;
    }
    for (std::uint32_t c = 0; c < f.channels; ++c) {
        switch (f.texel) {
        case Texel::unorm8:
            channels[c] = glm::unpackUnorm1x8(load<std::uint8_t>(texel, c));
            break;
        case Texel::snorm8:
            channels[c] = glm::unpackSnorm1x8(load<std::uint8_t>(texel, c));
            break;
        case Texel::uint8:
            channels[c] = static_cast<float>(load<std::uint8_t>(texel, c));
            break;
        case Texel::uint16:
            channels[c] = static_cast<float>(load<std::uint16_t>(texel, c));
            break;
        case Texel::unorm16:
            channels[c] = glm::unpackUnorm1x16(load<std::uint16_t>(texel, c));
            break;
        case Texel::snorm16:
            channels[c] = glm::unpackSnorm1x16(load<std::uint16_t>(texel, c));
            break;
        case Texel::half:
            channels[c] = glm::unpackHalf1x16(load<std::uint16_t>(texel, c));
            break;
        case Texel::uint32:
            channels[c] = static_cast<float>(load<std::uint32_t>(texel, c));
            break;
        default:
            channels[c] = load<float>(texel, c);
            break;
        }
    }
}
}
