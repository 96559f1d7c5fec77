// What the irradiance probes around a point say of its light.
// The includer defines, before this line:
//   struct ProbeSet                                where they lie, passed by value
//   int       probeStartAt(ProbeSet, vec3 position) a node whose part of space holds the point, or ~cell; 0, the root, always does
//   ProbeNode probeNodeAt(ProbeSet, uint node)
//   ProbeCell probeCellAt(ProbeSet, uint cell)
//   Probe     probeAt(ProbeSet, uint probe)
//   vec3      probeMeanAt(ProbeSet, uint probe)    its irradiance.c[0] alone
#ifndef AFTERGLOW_PROBE_LOOKUP_H
#define AFTERGLOW_PROBE_LOOKUP_H
#include "shaders/probe.h"
SHARED_BEGIN

// The cell that holds a point; outside of the level: the one at its border.
FN uint probeCellNumber(ProbeSet probes, vec3 position)
{
    int at = probeStartAt(probes, position);
    while (at >= 0) {
        ProbeNode node = probeNodeAt(probes, uint(at));
        at = dot(node.normal, position) > node.offset ? node.above : node.below;
    }
    return uint(~at);
}
FN ProbeCell probeCellOf(ProbeSet probes, vec3 position) { return probeCellAt(probes, probeCellNumber(probes, position)); }

// Irradiance / pi about `normal`.
FN vec3 probeLookup(ProbeSet probes, vec3 position, vec3 normal)
{
    ProbeCell cell = probeCellOf(probes, position);
    vec3 fraction = probeFraction(cell, position), sum = vec3(0.0f);
    for (int corner = 0; corner < 8; ++corner) {
        float weight = probeTrilinear(fraction, corner);
        if (weight > 0.0f) sum += weight * probeIrradiance(probeAt(probes, cell.probe[corner]), normal);
    }
    return max(sum, vec3(0.0f));
}

// Radiance averaged over all directions: what a medium that scatters evenly meets.
FN vec3 probeMeanRadiance(ProbeSet probes, vec3 position)
{
    ProbeCell cell = probeCellOf(probes, position);
    vec3 fraction = probeFraction(cell, position), sum = vec3(0.0f);
    for (int corner = 0; corner < 8; ++corner) {
        float weight = probeTrilinear(fraction, corner);
        if (weight > 0.0f) sum += weight * probeMeanAt(probes, cell.probe[corner]);
    }
    return shBasis(0, vec3(0.0f)) * sum;
}

SHARED_END
#endif
