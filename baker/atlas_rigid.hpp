// A chart laid flat as rigidly as possible: every triangle keeps its shape as well as its neighbours let it.
#pragma once
#include "baker/atlas_surface.hpp"

namespace afterglow
{
struct Net {
    std::vector<uint> triangles; // of the surface
    std::vector<uint> vertex;    // three per triangle: ids from 0, in the order in which relax() eliminates those of a small net
    std::vector<dvec2> points;   // per vertex, m: where to begin, and what comes of it
};

struct Strain {
    double stretch = 1.0; // Sander's L2 over the chart, 1: isometric
    double worst = 1.0;   // of a triangle: largest over smallest singular value
    bool flipped = false; // a triangle lost its orientation
};

void relax(const Surface& surface, Net& net);

// Measured, and the points scaled so that the area is the surface's.
Strain normalise(const Surface& surface, Net& net);
}
