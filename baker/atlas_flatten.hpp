// Lays charts flat: each is projected along its axis, turned until its rectangle is smallest, and set on the texels so that a straight
// border runs through texel centres: a bilinear lookup inside a rectangular chart then reads no texel outside it.
#pragma once
#include "baker/atlas_charts.hpp"
#include "baker/atlas_footprint.hpp"
#include <optional>

namespace afterglow
{
struct FlatChart {
    Triangles triangles;
    std::vector<dvec2> shape;   // three per triangle: m, turned so that its bounding rectangle is the smallest and lies down
    std::vector<uint> rim;      // where the sides of its border start, as corners of it
    std::vector<dvec2> corners; // `shape` on the texels, from the footprint's lower corner
    Footprint footprint;
};

// Shapes alone. A chart that folds over itself, as seen at `texel` (m), is halved until it does not: every triangle of the surface is in
// exactly one of the charts returned.
std::vector<FlatChart> flatten(const Surface& surface, const Charts& charts, double texel);

// Turns the corners so that their bounding rectangle is the smallest, and lies down: one side of the hull lies along it. Returns its size.
dvec2 turnToSmallestRectangle(std::vector<dvec2>& corners);

struct TexelOptions {
    double texelsPerMetre = 16;
    double margin = 1;     // texels around a chart that are its own: half the padding
    double largest = 4096; // texels along a chart and its margins
};

// False: some chart is too large.
bool setOnTexels(std::vector<FlatChart>& charts, const TexelOptions& options);
}
