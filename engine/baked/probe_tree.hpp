// The irradiance probes of a level and the tree that finds them (shaders/probe.h says what they hold, shaders/probe_lookup.h how it is
// read).
#pragma once
#include "engine/scene/scene.hpp"
#include "shaders/probe.h"
#include <vector>

namespace afterglow
{
struct ProbeTree {
    std::vector<Probe> probes;
    int order = 2;               // of their harmonics: of order 1 the rest is 0, and there is no lobe
    std::vector<vec3> positions; // world, m: where each was measured
    std::vector<ProbeCell> cells;
    std::vector<ProbeNode> nodes; // the first is the root; children come after their parents

    bool empty() const { return cells.empty(); }
};
}
