// A footprint on a grid of cells, row by row, and how much two of them overlap.
#pragma once
#include "baker/atlas_page.hpp"
#include <span>
#include <vector>

namespace afterglow
{
struct Run { // of cells in a row
    int begin, end;
};

struct Silhouette {
    ivec2 size{0}; // cells
    int turns = 0; // as its stance has them
    double area = 0.0;
    std::vector<Run> runs;
    std::vector<std::size_t> firstOf{0}; // per row, and one past the last

    std::span<const Run> row(int y) const
    {
        return {runs.begin() + std::ptrdiff_t(firstOf[std::size_t(y)]), runs.begin() + std::ptrdiff_t(firstOf[std::size_t(y) + 1])};
    }
};

// Of the cells, `cell` texels along an edge, those that are taken to a half or more.
Silhouette silhouette(const Stance& stance, int cell);

// Cells that both take; b stands at `apart` from a.
int overlap(const Silhouette& a, const Silhouette& b, ivec2 apart);
}
