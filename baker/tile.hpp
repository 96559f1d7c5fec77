// A tile of a lightmap on its way, the unit of work: what its paths have brought so far, and where that waits.
#pragma once
#include "baker/rounds.hpp"
#include "baker/tile_light.hpp"
#include <optional>

namespace afterglow
{
struct Tile {
    uint page;
    ivec2 at;
    std::uint64_t layer = 0; // whose light it holds: the one that is traced, or as that was in an earlier bake (reach.hpp)
    dvec3 told{0.0};         // sum over its texels of the squares of what it is off by for being of an earlier bake
    bool kept = false;       // it is of one
    TileNoise noise;
    std::optional<TileMask> open;      // openPoints(), once they have been asked for
    std::vector<TexelLight> light;     // empty: it has none, or it waits in the journal
    double squares = 0.0, total = 0.0; // of the half differences, and of the means, of its valid texels
    double share = 1.0;                // of the variance that independent paths would leave in a mean: theirs are spread evenly

    void measure(const std::vector<TexelLight>& of);
};

// Mean of the channels.
inline double grey(dvec3 colour) { return (colour.x + colour.y + colour.z) / 3.0; }

// Over some tiles, in their order: the same bits for any number of threads.
struct ErrorSum {
    double squares = 0.0, told = 0.0, total = 0.0, texels = 0.0;
    void add(const Tile& tile);
    double relative() const; // RMSE of a texel
};

// What a number of samples of a tile's texels are called by.
inline Unit unitOf(std::size_t tile, int samples, std::uint64_t layer)
{
    return {Job::lightmaps, std::uint32_t(tile), std::uint32_t(samples), layer};
}

// The tile's light, out of where it waited; and back, where it is to wait.
std::vector<TexelLight> takeLight(const BakeContext& context, std::size_t number, Tile& tile);
void giveLight(const BakeContext& context, Tile& tile, std::vector<TexelLight> light);
}
