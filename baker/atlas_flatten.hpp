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
    std::vector<dvec2> corners; // three per triangle: texels from the footprint's lower corner
    Footprint footprint;
};

struct FlattenOptions {
    double texelsPerMetre = 16;
    double margin = 1;     // texels around a chart that are its own: half the padding
    double largest = 4096; // texels along a chart and its margins
};

// A chart that folds over itself is halved until it does not. Every triangle of the surface is in exactly one of the charts returned;
// nothing is returned when one of them is too large.
std::optional<std::vector<FlatChart>> flatten(const Surface& surface, const Charts& charts, const FlattenOptions& options);
}
