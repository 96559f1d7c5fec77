// The smallest bake that shaders/probe_lookup.h can be compiled with: no probe at all.
#ifndef AFTERGLOW_TEST_DIALECT_PROBE_LOOKUP_H
#define AFTERGLOW_TEST_DIALECT_PROBE_LOOKUP_H
#include "shaders/probe.h"
SHARED_BEGIN

struct ProbeSet {
    uint any;
};

FN int probeStartAt(ProbeSet, vec3) { return 0; }
FN ProbeNode probeNodeAt(ProbeSet, uint)
{
    ProbeNode nothing;
    return nothing;
}
FN ProbeCell probeCellAt(ProbeSet, uint)
{
    ProbeCell nothing;
    return nothing;
}
FN Probe probeAt(ProbeSet, uint)
{
    Probe nothing;
    return nothing;
}
FN vec3 probeMeanAt(ProbeSet, uint) { return vec3(0.0f); }

SHARED_END
#endif
