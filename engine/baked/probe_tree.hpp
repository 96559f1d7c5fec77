// The irradiance probes of a level and the tree that finds them (shaders/probe.h says what they hold, shaders/probe_lookup.h how it is
// read).
#pragma once
#include "engine/scene/scene.hpp"
#include "shaders/probe.h"
#include <vector>

namespace afterglow
{
// Where a probe stands and why there; the letters of the file.
enum class ProbeStand : char {
    corner = 'c',  // at the corner of its cell's box
    slanted = 's', // a wall cuts the corner off: as near there as the cell reaches
    buried = 'b',  // moved into the cell, for the corner lies in a solid
    hidden = 'h',  // or its cell does not see the corner
    near = 'n',    // or a surface is too near
    lamp = 'l',    // or a lamp without a size is
};

struct ProbeTree {
    std::vector<Probe> probes;
    int order = 2;                  // of their harmonics: of order 1 the rest is 0, and there is no lobe
    std::vector<vec3> positions;    // world, m: where each was measured
    std::vector<ProbeStand> stands; // of each, or none: a file of another program may not say
    std::vector<ProbeCell> cells;
    std::vector<ProbeNode> nodes; // the first is the root; children come after their parents

    bool empty() const { return cells.empty(); }
};
}
