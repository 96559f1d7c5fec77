// Colours to the bytes of a texture's format and back: the one place where baked light is rounded.
#pragma once
#include "engine/baked/ktx2.hpp"
#include "shaders/glsl.h"
#include <span>

namespace afterglow
{
// What is wanted, or rgba32f where that would clip a value, or leave the brightest of a shared exponent less than its nine bits.
Ktx2Format holding(std::span<const shared::vec4> texels, Ktx2Format wanted);

// NaN becomes 0; what is beyond the format becomes its largest value. Alpha is left out by rgb9e5, and 1 when it is read.
std::vector<std::uint8_t> packTexels(std::span<const shared::vec4> texels, Ktx2Format format);
std::vector<shared::vec4> unpackTexels(std::span<const std::uint8_t> bytes, Ktx2Format format);

// Numbers as text that reads back to the bit, for key/value data: "0.125 2 -3e-05".
std::string numbersText(std::span<const double> numbers);

// Throws Error with `what` in its sentence unless the key is there and holds so many numbers that are finite as float, too.
std::vector<double> readNumbersText(const Ktx2& texture, const std::string& key, std::size_t count, const std::string& what);
}
