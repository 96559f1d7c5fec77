// glTF accessors as plain numbers: every component type, normalized integers, strides, sparse; each range is checked before it is read.
#pragma once
#include "engine/scene/document.hpp"
#include <cstdint>
#include <span>
#include <vector>

namespace afterglow
{
// `count` elements of `components` numbers each, one after the other.
struct Numbers {
    std::size_t count = 0;
    int components = 0;
    std::vector<float> values;
};

// Throws Malformed with a sentence that begins with the accessor's number: the caller says whose it is.
Numbers readNumbers(const Document& document, std::size_t accessor);
std::vector<std::uint32_t> readIndices(const Document& document, std::size_t accessor);

// The bytes of a buffer view.
std::span<const std::uint8_t> viewBytes(const Document& document, std::size_t view);
}
