// Where the probes of a partition's cells stand.
#pragma once
#include "baker/partition.hpp"
#include "engine/baked/probe_tree.hpp"
#include <array>
#include <map>

namespace afterglow
{
struct ProbeCorners {
    double inset; // m, from walls

    std::vector<dvec3> positions;
    std::vector<ProbeStand> stands;
    std::map<std::array<long long, 3>, std::vector<uint>> known; // by place, to find those that stand there already
};

// A cell's box: its bounds, off its walls.
struct CellBox {
    dvec3 lower, upper;
    std::array<uint, 8> probe;
};
// Adds the probes that no cell had yet to `corners`.
CellBox placeCorners(const Partition& partition, const Partition::Cell& cell, ProbeCorners& corners);

// A point of the cell with `clear` m about it, near `wanted`: there, or as far towards the cell's anchor as needed.
dvec3 freePoint(const Partition& partition, const Partition::Cell& cell, dvec3 wanted, double clear);
}
