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
    explicit Page(int width) : width_(width), words_(std::size_t(width + 63) / 64), blocked_(2 * words_ + 1), smeared_(2 * words_ + 1) {}

    // A low, then leftmost free spot at or above `from`, that leaves the page no higher than `mostHeight`.
    std::optional<ivec2> find(const Stance& stance, int from, int mostHeight);

    void take(const Stance& stance, ivec2 at);

    int height() const { return height_; }

private:
    using Bits = std::vector<std::uint64_t>; // words_ a row, one bit per texel: texel 0 is bit 0 of word 0

    struct FreeRun { // the longest of a row
        int texels;
        bool known; // or no longer than that
    };

    int aboveTightRows(const Block& block, int y);
    bool hasRoom(int row, int width);
    int longestFree(int row) const;
    int firstFree(const Stance& stance, int y);
    int firstUnblocked(int x) const;
    int lastTaken(ivec2 from, ivec2 size) const;
    void blockFor(ivec2 size, int y);
    template <typename Call>
    void eachRow(int first, int end, Call call) const;

    int width_, height_ = 0;
    std::size_t words_;
    std::vector<Bits> levels_;     // row r of level k: what is taken in any of the rows r * 2^k and the 2^k - 1 above
    std::vector<FreeRun> longest_; // per row
    Bits blocked_, smeared_;       // a row, and zeros behind it
};
}
