// Where a cell of the irradiance probes lies.
#pragma once
#include "shaders/probe.h"

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
}
