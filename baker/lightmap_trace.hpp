// Traces the tiles of lightmap pages, round by round, and fills the cache that later paths look light up in.
#pragma once
#include "baker/light_layers.hpp"
#include "baker/lightmap.hpp"
#include "baker/tile.hpp"

namespace afterglow
{
// The pages on their way.
struct Bed {
    const std::vector<LightmapPlace>& places;
    const std::vector<ivec2>& pageSizes;
    std::vector<PageTriangles> triangles; // of each page
    std::vector<Tile> tiles;              // without light

    Bed(const World& world, const std::vector<LightmapPlace>& where, const std::vector<ivec2>& sizes);
    Tile tileOf(std::size_t number, std::uint64_t layer) const { return {tiles[number].page, tiles[number].at, layer}; }

    // Of the tile's texels, without those that lie in solids: rays tell, once.
    TilePoints pointsOf(const BakeContext& context, Tile& tile) const;
};

// Paths of all tiles that have so many samples.
std::uint64_t pathsOf(const std::vector<int>& samples);

// What is traced first of each tile, and what of that fills the cache.
std::vector<int> firstSamples(const Bed& bed, const LightmapEffort& effort);
std::vector<int> pilotSamples(const BakeContext& context, const Bed& bed, const LightmapEffort& effort);

// Brings every tile to its number of samples; from then on, paths look up what is known.
void traceAndLearn(BakeContext& context, const Bed& bed, std::vector<Tile>& tiles, const std::vector<int>& samples);

// Is told how many paths a layer takes in all, as far as that is known.
using Expect = std::function<void(std::uint64_t paths)>;

// All tiles by one layer of light.
std::vector<Tile> traced(BakeContext& context, const Bed& bed, const LightmapEffort& effort, const Expect& expect);

// Keeps what the texels of a tile have.
void learn(const Tile& tile, const std::vector<TexelLight>& light, LightCache& cache);
}
