// Parts a level's free space into convex cells that no wall reaches through: the tree of the irradiance probes (shaders/probe.h).
#pragma once
#include "baker/region.hpp"
#include "baker/solids.hpp"
#include "shaders/probe.h"
#include <climits>
#include <functional>

namespace afterglow
{
constexpr int kNowhere = INT_MIN; // a child of ProbeNode: all of it lies inside solids
constexpr int kWhole = INT_MAX;   // no child: a cell was not cut

// How large a cell may be around a place, m.
using Spacing = std::function<double(dvec3 lower, dvec3 upper)>;

struct Partition {
    const World& world;
    const Solids& solids;
    dvec3 lower, upper;      // of the level: beyond is nothing
    bool walls = true;       // false: cuts alone, as in a plain grid
    Spacing finest;          // m: cells are not cut smaller for what stands in them
    std::size_t most;        // cells, beyond which none is cut for that
    double thin = 1e-3;      // m: what reaches into a cell by less is not in it
    std::vector<vec3> lamps; // without a size: near them there is no end to their light

    struct Cell {
        Region region;
        std::vector<uint> triangles; // that reach into it
        dvec3 anchor;                // a free point that sees most of it
        int instead = kWhole;        // the child that took its place
    };
    std::vector<Cell> cells;
    std::vector<ProbeNode> nodes;

    bool sees(dvec3 from, dvec3 to) const; // nothing between
};

// Parts a region; returns it as a child of ProbeNode.
int part(Partition& partition, Region region, std::vector<uint> triangles, const Spacing& spacing);

// Cuts a cell in the middle of its long axes; what it was made of is part()ed anew. A cell stays where it is, for others name it by its
// number.
void cutCell(Partition& partition, std::size_t cell);
}
