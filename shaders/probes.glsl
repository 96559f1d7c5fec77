// The irradiance probes of the scene's set, for passes that look them up (shaders/probe_lookup.h).
#ifndef AFTERGLOW_PROBES_GLSL
#define AFTERGLOW_PROBES_GLSL
#include "shaders/bindings.glsl"

struct ProbeSet {
    uint boxes;
};
uint probeBoxCount(ProbeSet all) { return all.boxes; }
ProbeBox probeBoxAt(ProbeSet all, uint box) { return probeBoxes[box]; }
Probe probeAt(ProbeSet all, uint probe) { return probes[probe]; }

#include "shaders/probe_lookup.h"

#endif
