// What a change of a level reaches: which tiles of a lightmap stay as an earlier bake left them (--incremental).
// The first paths of every tile are traced in the level as it is, by the same random numbers as in the level as it was: where nothing that
// they meet has changed they bring the same, bit by bit. Half of them decides: tiles are kept, those that differ least first, until the
// squares of their differences are a small share of the squared error of the whole, none by more than its own noise. The other half, which
// had no say, tells how far off the kept ones are: its paths are independent, so that its squares are expected to be those of the change,
// and more by their own noise. They are added to the stated error. A tile whose points moved is never kept; one that is kept again is
// compared with the level that it was traced in, so that small steps do not add up unseen.
#pragma once
#include "baker/tile.hpp"
#include <optional>

namespace afterglow
{
constexpr double kGivenUp = 0.05; // of the squared error: it grows by 2.5 %
constexpr double kRoom = 0.1;     // of a target's square, for that and the noise of what tells it

// What a bake leaves of a tile.
struct LeftTile {
    std::uint64_t layer = 0; // of which its light is
    std::int64_t samples = 0;
    double error = 0.0; // sum over its texels of the squared error, mean of the channels
    dvec3 told{0.0};    // as Tile's
};

// What an earlier bake left of a layer of light.
struct Former {
    std::uint64_t layer = 0; // 0: nothing
    std::vector<LeftTile> tiles;
};
Former formerOf(const BakeContext& context, std::size_t tiles);

// Between two levels, a tile's first paths.
struct TileChange {
    double seen = 0.0;  // sum over the texels of the squared difference, mean of the channels, by the half that decides
    dvec3 told{0.0};    // the same of each channel by the other half
    double error = 0.0; // as LeftTile's
    bool kept = false;  // it may be, to begin with
};
TileChange changeOf(const std::vector<TexelLight>& before, const std::vector<TexelLight>& now);
void keepLeastChanged(std::vector<TileChange>& tiles); // leaves `kept` those that are

// Takes over what stays; all of it where the layer is the same. Otherwise the first paths of all tiles have been traced.
void takeOver(BakeContext& context, const Former& former, std::vector<Tile>& tiles);

// What the tiles' error is to fall to. Bakes that later ones build on leave room below their target for what those give up: they would
// trace all of it anew.
struct Aim {
    double error = 0.0, target = 0.0;   // of the tiles that do not stay, in the same unit
    std::optional<std::uint64_t> layer; // tiles of any other stay as they are, as long as these can make up for them

    bool stays(const Tile& tile) const { return layer && tile.layer != *layer; }
};
Aim aimOf(const BakeContext& context, const std::vector<Tile>& tiles, double target);

// For a later bake: what was traced, and what was taken over.
void leave(BakeContext& context, const std::vector<Tile>& tiles);
}
