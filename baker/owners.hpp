// Whose a texel of a lightmap page is: the chart that a bilinear lookup there belongs to.
#pragma once
#include "baker/world.hpp"
#include "engine/baked/baked.hpp"

namespace afterglow
{
constexpr uint kNobody = ~0u;

struct Owners {
    std::vector<uint> chartOf;              // of each triangle of the world: its chart, numbered over the level; kNobody without a lightmap
    std::vector<std::vector<uint>> texelOf; // of each texel of each page; kNobody: no lookup touches it
};

// Triangles of an object that share a place on the page are of one chart.
Owners findOwners(const World& world, const std::vector<LightmapPlace>& places, const std::vector<ivec2>& pageSizes);

// A corner of a world triangle on its page, in texels.
dvec2 onPage(const World& world, const std::vector<LightmapPlace>& places, const std::vector<ivec2>& pageSizes, uint triangle, uint corner);
}
