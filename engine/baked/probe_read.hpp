// shaders/probe_lookup.h on the CPU: the law by which shaders read a tree of probes, from one in memory.
#pragma once
#include "engine/baked/probe_tree.hpp"

namespace shared
{
struct ProbeSet {
    const afterglow::ProbeTree* tree;
};
FN int probeStartAt(ProbeSet, vec3) { return 0; }
FN ProbeNode probeNodeAt(ProbeSet probes, uint node) { return probes.tree->nodes[node]; }
FN ProbeCell probeCellAt(ProbeSet probes, uint cell) { return probes.tree->cells[cell]; }
FN Probe probeAt(ProbeSet probes, uint probe) { return probes.tree->probes[probe]; }
FN vec3 probeMeanAt(ProbeSet probes, uint probe) { return probes.tree->probes[probe].irradiance.c[0]; }
}

#include "shaders/probe_lookup.h"
