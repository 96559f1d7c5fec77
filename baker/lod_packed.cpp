#include "baker/lod_packed.hpp"
#include "engine/baked/bytes.hpp"

namespace afterglow
{
static constexpr std::size_t kHead = 16; // error, turn, how many indices follow

std::vector<std::uint8_t> packLevels(const std::vector<LodLevel>& levels)
{
    Bytes bytes;
    for (const LodLevel& level : levels) {
        putFloat(bytes, level.error);
        putFloat(bytes, level.turn);
        put64(bytes, level.indices.size());
        for (const uint index : level.indices) put32(bytes, index);
    }
    return bytes;
}

std::optional<std::vector<LodLevel>> unpackLevels(const std::vector<std::uint8_t>& bytes)
{
    std::vector<LodLevel> levels;
    const std::uint8_t *at = bytes.data(), *const end = at + bytes.size();
    while (at < end) {
        if (std::size_t(end - at) < kHead) return std::nullopt;
        LodLevel& level = levels.emplace_back();
        level.error = getFloat(at);
        level.turn = getFloat(at + 4);
        const std::uint64_t count = get64(at + 8);
        at += kHead;
        if (count > std::size_t(end - at) / 4) return std::nullopt;
        for (std::uint64_t i = 0; i < count; ++i, at += 4) level.indices.push_back(get32(at));
    }
    return levels;
}
}
