// The bitmap of a page's taken texels, and where a footprint still finds room on it.
#pragma once
#include "baker/atlas_footprint.hpp"
#include <cstdint>
#include <optional>
#include <vector>

namespace afterglow
{
// A footprint turned counter-clockwise by quarters. Its blocks as they are asked: the largest one inside first, for a spot that is taken
// mostly shows there.
struct Stance {
    ivec2 size{0};
    int turns = 0;
    std::vector<Block> blocks; // disjoint: what is taken
    std::vector<Block> asked;  // cover the same texels
};

// The turns that differ, `footprint` as it is first.
std::vector<Stance> stancesOf(const Footprint& footprint);

class Page
{
public:
    explicit Page(int width) : width_(width), words_(std::size_t(width + 63) / 64), blocked_(words_), together_(words_) {}

    // A low, then leftmost free spot at or above `from`, that leaves the page no higher than `mostHeight`.
    std::optional<ivec2> find(const Stance& stance, int from, int mostHeight);

    void take(const Stance& stance, ivec2 at);

    int height() const { return height_; }

private:
    using Bits = std::vector<std::uint64_t>; // words_ a row, one bit per texel: texel 0 is bit 0 of word 0

    int aboveTightRows(const Block& block, int y);
    int longestFree(int row);
    int firstFree(const Stance& stance, int y);
    int firstZero(int last) const;
    void gather(int first, int end);

    int width_, height_ = 0;
    std::size_t words_;
    std::vector<Bits> levels_; // row r of level k: what is taken in any of the rows r * 2^k and the 2^k - 1 above
    std::vector<int> longest_; // per row: the longest run of free texels, where it is known
    Bits blocked_, together_;
};
}
