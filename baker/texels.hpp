// Which points of which surfaces a lightmap texel stands for: each page's triangles, and a tile of texels rasterised finely.
#pragma once
#include "baker/solids.hpp"
#include "engine/baked/baked.hpp"
#include <array>
#include <bitset>
#include <vector>

namespace afterglow
{
constexpr int kTileEdge = 8; // texels: the unit of work, small enough that its texels see nearly the same
constexpr int kFineEdge = 4; // sample positions along a texel's edge
constexpr int kTileTexels = kTileEdge * kTileEdge;

// A point of a surface that a texel stands for.
struct TexelPoint {
    uint triangle; // of the world
    vec2 barycentric;
};

using TilePoints = std::vector<std::vector<TexelPoint>>; // of each texel, in row order

// The triangles of one page, binned by tile.
struct PageTriangles {
    ivec2 tiles;                           // count along each axis
    std::vector<std::vector<uint>> byTile; // world triangles in ascending order
};

// One per page; world triangles whose object has no place are left out. Page uv = uv1 * scale + offset.
std::vector<PageTriangles> binTriangles(const World& world, const std::vector<LightmapPlace>& places, const std::vector<ivec2>& pageSizes);

// The points of each texel of a tile; none: the texel is outside every chart. Triangles too small to meet a sample position
// still give their centroid, so that no triangle is left without light.
TilePoints rasteriseTile(const World& world, const std::vector<LightmapPlace>& places, ivec2 pageSize, const PageTriangles& page,
                         ivec2 tile);

// Of each texel's points, in their order, those that count, a bit each.
using TileMask = std::array<std::uint16_t, kTileTexels>;
static_assert(kFineEdge * kFineEdge <= 16);

// Those outside of solids (a floor goes on under a wall): none of a texel's where next to none is outside, unless somebody sees them there.
TileMask openPoints(const World& world, const Solids& solids, const TilePoints& texels);
void leaveOutOthers(const TileMask& counting, TilePoints& texels);

// Texels whose points do not all see their first: a wall parts them.
std::bitset<kTileTexels> partedTexels(const World& world, const TilePoints& texels);
}
