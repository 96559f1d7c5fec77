// A primitive's levels of detail as the bytes of a unit of work (journal.hpp).
#pragma once
#include "engine/baked/baked.hpp"
#include <optional>

namespace afterglow
{
std::vector<std::uint8_t> packLevels(const std::vector<LodLevel>& levels);

// Nothing when the bytes are no levels.
std::optional<std::vector<LodLevel>> unpackLevels(const std::vector<std::uint8_t>& bytes);
}
