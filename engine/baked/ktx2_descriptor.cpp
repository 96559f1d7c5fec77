#include "engine/baked/ktx2_descriptor.hpp"
#include "engine/baked/bytes.hpp"
#include <bit>

namespace afterglow
{
// Data Format Specification 1.3, tables of chapter 5.
constexpr std::uint32_t kModelRgbsda = 1, kPrimariesBt709 = 1, kTransferLinear = 1, kTransferSrgb = 2;
constexpr std::uint32_t kRed = 0, kGreen = 1, kBlue = 2, kAlpha = 15;
constexpr std::uint32_t kLinear = 0x10, kExponent = 0x20, kSigned = 0x40, kFloat = 0x80;

struct Sample {
    std::uint32_t bitOffset, bits, channel, lower, upper;
};

static std::vector<Sample> samples(Ktx2Format format)
{
    constexpr std::uint32_t channels[] = {kRed, kGreen, kBlue, kAlpha};
    std::vector<Sample> all;
    switch (format) {
    case Ktx2Format::r8:
        return {{0, 8, kRed, 0, 255}};
    case Ktx2Format::rgba8:
    case Ktx2Format::srgba8:
        for (std::uint32_t c = 0; c < 4; ++c) all.push_back({8 * c, 8, channels[c], 0, 255});
        if (format == Ktx2Format::srgba8) all[3].channel |= kLinear; // alpha has no transfer function
        return all;
    case Ktx2Format::rgba16f:
    case Ktx2Format::rgba32f: {
        const std::uint32_t bits = format == Ktx2Format::rgba16f ? 16 : 32;
        const auto minusOne = std::bit_cast<std::uint32_t>(-1.0f), one = std::bit_cast<std::uint32_t>(1.0f);
        for (std::uint32_t c = 0; c < 4; ++c) all.push_back({bits * c, bits, channels[c] | kSigned | kFloat, minusOne, one});
        return all;
    }
    case Ktx2Format::rgb9e5:
        // A mantissa and, for each channel, the shared exponent with its bias 15; 1.0 is mantissa 256 with exponent 16
        for (std::uint32_t c = 0; c < 3; ++c) {
            all.push_back({9 * c, 9, channels[c], 0, 16u << 9 | 256u});
            all.push_back({27, 5, channels[c] | kExponent, 15, 31});
        }
        return all;
    }
    return all;
}

std::vector<std::uint8_t> dataFormatDescriptor(Ktx2Format format)
{
    const std::vector<Sample> all = samples(format);
    const std::uint32_t transfer = format == Ktx2Format::srgba8 ? kTransferSrgb : kTransferLinear;
    const auto blockBytes = std::uint32_t(24 + 16 * all.size());
    Bytes bytes;
    put32(bytes, 4 + blockBytes);
    put32(bytes, 0);                    // Khronos, basic format
    put32(bytes, blockBytes << 16 | 2); // version 1.3
    put32(bytes, transfer << 16 | kPrimariesBt709 << 8 | kModelRgbsda);
    put32(bytes, 0);                                 // texel block of 1 x 1 x 1 x 1
    put64(bytes, std::uint64_t(texelBytes(format))); // bytes of plane 0; no others
    for (const Sample& sample : all) {
        put32(bytes, sample.channel << 24 | (sample.bits - 1) << 16 | sample.bitOffset);
        put32(bytes, 0); // sample position
        put32(bytes, sample.lower);
        put32(bytes, sample.upper);
    }
    return bytes;
}
}
