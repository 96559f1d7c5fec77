// Where to cut a surface: triangles grow into charts that one plane sees without folds and nearly without stretch.
// This work is based on: hierarchical face clustering (Garland, Willmott, Heckbert 2001) under the L2,1 energy of variational shape
// approximation (Cohen-Steiner, Alliez, Desbrun 2004).
#pragma once
#include "baker/atlas_surface.hpp"
#include "baker/weld.hpp"
#include "engine/core/progress.hpp"

namespace afterglow
{
constexpr double kCreaseCosine = 0.8;   // two faces that meet at more than 37 degrees: light breaks there, and so do charts
constexpr double kFlattestCosine = 0.5; // of a triangle's normal and its chart's axis: the projection stretches by its inverse

using Triangles = std::vector<uint>; // ascending

struct Charts {
    std::vector<Triangles> charts;
    std::vector<uint> across;     // per corner: where the side across that one starts; kNoCorner at borders of the surface and its pieces
    std::vector<uint> neighbours; // per corner: the triangle of `across`; kNoTriangle where there is none
    int partedEdges = 0;          // where sheets meet that no chart may join
};
constexpr uint kNoTriangle = ~0u;

// `texel` (m): charts smaller than a few of them give up their shape to join a neighbour.
// Advances by each triangle that joins another.
Charts growCharts(const Surface& surface, double texel, const Advance& advance);
}
