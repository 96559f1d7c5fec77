// Where a cell of the irradiance probes lies.
#pragma once
#include "engine/baked/probe_tree.hpp"
#include <algorithm>

namespace afterglow
{
// Of the box that a cell's probes stand at the corners of, m; 0 on an axis that is flat.
inline vec3 extentOf(const ProbeCell& cell)
{
    vec3 extent(0.0f);
    for (int axis = 0; axis < 3; axis++)
        if (cell.perExtent[axis] > 0.0f) extent[axis] = 1.0f / cell.perExtent[axis];
    return extent;
}

// Mean over space of a cell's least edge, m: the probes do not tell apart what stands nearer together. Flat cells have no say; of no other,
// infinite.
inline float meanCellEdge(const ProbeTree& tree)
{
    double space = 0.0, sum = 0.0;
    for (const ProbeCell& cell : tree.cells) {
        const vec3 extent = extentOf(cell);
        const double volume = double(extent.x) * double(extent.y) * double(extent.z);
        space += volume, sum += volume * double(std::min({extent.x, extent.y, extent.z}));
    }
    return space > 0.0 ? float(sum / space) : kFloatMax;
}
}
