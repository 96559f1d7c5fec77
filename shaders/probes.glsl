// The irradiance probes of the scene's set, for passes that look them up (shaders/probe_lookup.h).
#ifndef AFTERGLOW_PROBES_GLSL
#define AFTERGLOW_PROBES_GLSL
#include "shaders/bindings.glsl"

struct ProbeSet {
    uint any; // 0: none
};
ProbeNode probeNodeAt(ProbeSet all, uint node) { return probeNodes[node]; }
ProbeCell probeCellAt(ProbeSet all, uint cell) { return probeCells[cell]; }
Probe probeAt(ProbeSet all, uint probe) { return probes[probe]; }
vec3 probeMeanAt(ProbeSet all, uint probe) { return probes[probe].irradiance.c[0]; }

#include "shaders/probe_lookup.h"

#endif
