// The cells of a tree of probes while it is baked: placed, lit, tested, cut.
#pragma once
#include "baker/probe_corners.hpp"
#include "baker/probe_light.hpp"
#include "baker/probes.hpp"

namespace afterglow
{
// What a cell of the partition is to the search.
struct Chamber {
    CellBox box;
    bool placed = false, tested = false;
    double volume = 0.0; // m3
    double error2 = 0.0; // mean square of what its interpolation errs by: irradiance / pi
    double light = 0.0;  // mean irradiance / pi
};

struct Search {
    BakeContext& context;
    const ProbeEffort& effort;
    Partition partition;
    ProbeCorners corners;
    std::vector<ProbeLight> lights; // of the corners
    std::vector<Chamber> chambers;  // as partition.cells
    std::uint32_t units = 0;        // of work, so far

    bool alive(std::size_t cell) const { return partition.cells[cell].instead == kWhole; }
};

// Probes for the cells that have none yet.
void placeProbes(Search& search);

// What interpolation errs by in the cells that were not tested yet.
void testCells(Search& search);

// A cell as a lookup reads it.
ProbeCell cellOf(const CellBox& box);
}
