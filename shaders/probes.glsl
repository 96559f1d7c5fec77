// The irradiance probes of the scene's set, for passes that look them up (shaders/probe_lookup.h).
#ifndef AFTERGLOW_PROBES_GLSL
#define AFTERGLOW_PROBES_GLSL
#include "shaders/bindings.glsl"

// Texels of a buffer: on a CPU four numbers by one fetch cost what one costs by a load from a storage buffer.
struct ProbeSet {
    uint any; // 0: none
};

int probeStartAt(ProbeSet all, vec3 position) { return probeStarts[probeGridBox(probeGrid, position)]; }

ProbeNode probeNodeAt(ProbeSet all, uint node)
{
    int first = int(node) * kTexelsOfNode;
    vec4 plane = texelFetch(probeTree, first);
    vec2 children = texelFetch(probeTree, first + 1).xy;
    return ProbeNode(plane.xyz, plane.w, int(children.x), int(children.y));
}

ProbeCell probeCellAt(ProbeSet all, uint cell)
{
    int first = probeGrid.firstCell + int(cell) * kTexelsOfCell;
    vec4 lower = texelFetch(probeTree, first), below = texelFetch(probeTree, first + 2), above = texelFetch(probeTree, first + 3);
    vec2 rest = texelFetch(probeTree, first + 1).xy;
    return ProbeCell(lower.xyz, vec3(lower.w, rest),
                     uint[8](uint(below.x), uint(below.y), uint(below.z), uint(below.w), uint(above.x), uint(above.y), uint(above.z), uint(above.w)));
}

Probe probeAt(ProbeSet all, uint probe)
{
    vec4 t[kTexelsOfProbe];
    for (int i = 0; i < kTexelsOfProbe; ++i) t[i] = texelFetch(probes, int(probe) * kTexelsOfProbe + i);
    return Probe(Sh9(vec3[9](t[0].xyz, vec3(t[0].w, t[1].xy), vec3(t[1].zw, t[2].x), t[2].yzw, t[3].xyz, vec3(t[3].w, t[4].xy),
                             vec3(t[4].zw, t[5].x), t[5].yzw, t[6].xyz)),
                 vec3(t[6].w, t[7].xy), vec3(t[7].zw, t[8].x));
}
vec3 probeMeanAt(ProbeSet all, uint probe) { return texelFetch(probes, int(probe) * kTexelsOfProbe).xyz; }

#include "shaders/probe_lookup.h"

#endif
