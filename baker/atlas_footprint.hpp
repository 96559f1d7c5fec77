// Which texels a chart owns, and whether it folds over itself: two questions to the same flattened triangles.
#pragma once
#include "shaders/glsl.h"
#include <cstdint>
#include <span>
#include <vector>

namespace afterglow
{
using namespace shared;

struct Block { // of texels
    ivec2 lower, size;
};

// The texels nearer than `margin` to a chart, in the larger of x and y: at a margin of 1 exactly those that a bilinear lookup inside the
// chart may touch. Disjoint blocks cover them; disjoint footprints share no lookup.
struct Footprint {
    ivec2 size{0};
    std::vector<Block> blocks;
    bool turns = true; // it may lie on a page turned by quarters
};

// Disjoint blocks of the set texels, row after row.
std::vector<Block> blocksOf(const std::vector<std::uint8_t>& taken, ivec2 size);

// Charts below are three corners per triangle, all of one winding, and the corners at which the sides start that no other triangle continues:
// their rim. Sides that one does may be among it.

// In texels: texel i covers [i, i + 1). `origin` receives the texel that is the footprint's (0, 0).
Footprint footprint(std::span<const dvec2> corners, std::span<const uint> rim, double margin, ivec2& origin);

// Some point of the plane lies inside two triangles; looked for at samples `spacing` apart, coarser where the chart is large.
bool foldsOver(std::span<const dvec2> corners, std::span<const uint> rim, double spacing);

// Some texel's centre lies inside a triangle: the chart has light of its own.
bool coversTexel(std::span<const dvec2> corners, std::span<const uint> rim);
}
