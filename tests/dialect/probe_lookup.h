// The smallest bake that shaders/probe_lookup.h can be compiled with: no probe at all.
#ifndef AFTERGLOW_TEST_DIALECT_PROBE_LOOKUP_H
#define AFTERGLOW_TEST_DIALECT_PROBE_LOOKUP_H
#include "shaders/gpu_baked.h"
SHARED_BEGIN

struct ProbeSet {
    uint boxes;
};

FN uint probeBoxCount(ProbeSet probes) { return probes.boxes; }
FN ProbeBox probeBoxAt(ProbeSet, uint)
{
    ProbeBox nothing;
    return nothing;
}
FN Probe probeAt(ProbeSet, uint)
{
    Probe nothing;
    return nothing;
}

SHARED_END
#endif
