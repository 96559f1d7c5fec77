// The Data Format Descriptor of a KTX2 file: what the bits of a texel mean, for a reader that knows no VkFormat.
#pragma once
#include "engine/baked/ktx2.hpp"

namespace afterglow
{
// With its leading total size; a multiple of four bytes.
std::vector<std::uint8_t> dataFormatDescriptor(Ktx2Format format);
}
