// The cells of a tree of probes while it is baked: placed, lit, tested, cut.
#pragma once
#include "baker/probe_corners.hpp"
#include "baker/probe_light.hpp"
#include "baker/probes.hpp"

namespace afterglow
{
constexpr double kDark = 0.01; // of the level's mean light: what is darker may err by more

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
    std::vector<ProbeSums> sums;    // of the corners
    std::vector<ProbeLight> lights; // what those say
    std::vector<Chamber> chambers;  // as partition.cells
    std::uint32_t units = 0;        // of work, so far
    std::uint64_t work = 0;         // of these, as times the least paths of a probe
    double foretold = 0.0;          // the same once all is done

    bool alive(std::size_t cell) const { return partition.cells[cell].instead == kWhole; }
};

// Probes for the cells that have none yet.
void placeProbes(Search& search);

// Goes on with probes that have fewer paths than that; `paths`: as sums.
void tracePaths(Search& search, const std::vector<int>& paths);

// What interpolation errs by in the cells that were not tested yet, or in one of so many of them.
constexpr std::size_t kTests = 5; // of a cell
void testCells(Search& search, std::size_t ofEach = 1);

// A cell as a lookup reads it.
ProbeCell cellOf(const CellBox& box);
}
