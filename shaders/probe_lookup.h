// What the irradiance probes around a point say of its light: eight in each box, and boxes that share where they overlap.
// The includer defines, before this line:
//   struct ProbeSet                              where they lie, passed by value
//   uint     probeBoxCount(ProbeSet)
//   ProbeBox probeBoxAt(ProbeSet, uint box)
//   Probe    probeAt(ProbeSet, uint probe)
#ifndef AFTERGLOW_PROBE_LOOKUP_H
#define AFTERGLOW_PROBE_LOOKUP_H
#include "shaders/gpu_baked.h"
#include "shaders/probe.h"
SHARED_BEGIN

// Sum of a box's eight weighted probes, and the sum of their weights in w.
FN vec4 probeBoxSum(ProbeSet probes, ProbeBox box, vec3 position, vec3 normal, vec3 unitPosition)
{
    ProbeCell cell = probeCell(unitPosition, box.count);
    vec4 sum = vec4(0.0f);
    for (int corner = 0; corner < 8; ++corner) {
        float trilinear = probeTrilinear(cell, corner);
        if (!(trilinear > 0.0f)) continue;
        ivec3 at = probeCorner(cell, corner, box.count);
        Probe probe = probeAt(probes, box.first + uint(probeIndex(at, box.count)));
        vec3 toProbe = box.toWorld * vec4(probeUnitPosition(at, box.count), 1.0f) - position;
        float weight = probeWeight(trilinear, probe.validity, toProbe, normal);
        sum += weight * vec4(shIrradiance(probe.irradiance, normal), 1.0f);
    }
    return sum;
}

// Irradiance / pi about `normal`. Every box that holds the point has a share, which fades over half a cell beyond its walls. A point outside
// of all of them gets the border of the nearest, however far: the sky never breaks in. 0 where no probe knows anything.
FN vec3 probeLookup(ProbeSet probes, vec3 position, vec3 normal)
{
    vec4 sum = vec4(0.0f);
    float nearest = kFloatMax;
    uint nearestBox = 0u;
    for (uint i = 0u; i < probeBoxCount(probes); ++i) {
        ProbeBox box = probeBoxAt(probes, i);
        vec3 unitPosition = box.toUnit * vec4(position, 1.0f);
        vec3 outside = mat3(box.toWorld) * max(abs(unitPosition) - 0.5f, vec3(0.0f));
        if (dot(outside, outside) < nearest) {
            nearest = dot(outside, outside);
            nearestBox = i;
        }
        float share = boxShare(unitPosition, 0.5f / vec3(max(box.count - 1, ivec3(1))));
        if (!(share > 0.0f)) continue;
        vec4 value = probeBoxSum(probes, box, position, normal, unitPosition);
        if (value.w > 0.0f) sum += share * vec4(vec3(value) / value.w, 1.0f);
    }
    if (nearest > 0.0f && nearest < kFloatMax && !(sum.w > 0.0f)) {
        ProbeBox box = probeBoxAt(probes, nearestBox);
        sum = probeBoxSum(probes, box, position, normal, box.toUnit * vec4(position, 1.0f));
    }
    return sum.w > 0.0f ? vec3(sum) / sum.w : vec3(0.0f);
}

SHARED_END
#endif
