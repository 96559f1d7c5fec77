// What the bake says of the light at a point: irradiance / pi from lightmaps or probes, and what a glossy surface mirrors.
#ifndef AFTERGLOW_INDIRECT_GLSL
#define AFTERGLOW_INDIRECT_GLSL
#include "shaders/bindings.glsl"
#include "shaders/gbuffer.h"
#include "shaders/probe.h"
#include "shaders/reflection.h"
#include "shaders/sh.h"

// The uniform index first: a divergent one costs three times as much on a CPU.
vec3 lightmapValue(uint pages, uint page, vec2 uv)
{
    if (pages == 1u) return textureLod(lightmaps[0], uv, 0.0).rgb;
    return textureLod(lightmaps[nonuniformEXT(page)], uv, 0.0).rgb;
}

// 0 outside of the box, 1 inside, a short ramp between: half a cell of a probe box.
float boxShare(vec3 unitPosition, vec3 ramp)
{
    vec3 inside = clamp((0.5 + ramp - abs(unitPosition)) / ramp, 0.0, 1.0);
    return inside.x * inside.y * inside.z;
}

// Sum of a box's eight weighted probes, and the sum of their weights in w.
vec4 probeBoxIrradiance(ProbeBox box, vec3 position, vec3 normal, vec3 unitPosition)
{
    ProbeCell cell = probeCell(unitPosition, box.count);
    vec4 sum = vec4(0.0);
    for (int corner = 0; corner < 8; ++corner) {
        float trilinear = probeTrilinear(cell, corner);
        if (!(trilinear > 0.0)) continue;
        ivec3 at = probeCorner(cell, corner, box.count);
        uint index = box.first + uint(probeIndex(at, box.count));
        vec3 toProbe = box.toWorld * vec4(probeUnitPosition(at, box.count), 1.0) - position;
        float weight = probeWeight(trilinear, probes[index].validity, toProbe, normal);
        vec3 value = vec3(0.0);
        for (int i = 0; i < 9; ++i) value += probes[index].irradiance.c[i] * shBasis(i, normal);
        sum += weight * vec4(max(value, vec3(0.0)), 1.0);
    }
    return sum;
}

// Boxes share where they overlap. A point outside of all of them gets the border of the nearest, however far; one among invalid probes
// only gets `fallback`.
vec3 probeValue(uint boxes, vec3 position, vec3 normal, vec3 fallback)
{
    vec4 sum = vec4(0.0);
    float nearest = kFloatMax;
    uint nearestBox = 0u;
    for (uint i = 0u; i < boxes; ++i) {
        ProbeBox box = probeBoxes[i];
        vec3 unitPosition = box.toUnit * vec4(position, 1.0);
        vec3 outside = mat3(box.toWorld) * max(abs(unitPosition) - 0.5, vec3(0.0));
        if (dot(outside, outside) < nearest) {
            nearest = dot(outside, outside);
            nearestBox = i;
        }
        float share = boxShare(unitPosition, 0.5 / vec3(max(box.count - 1, ivec3(1))));
        if (!(share > 0.0)) continue;
        vec4 value = probeBoxIrradiance(box, position, normal, unitPosition);
        if (value.w > 0.0) sum += share * vec4(value.rgb / value.w, 1.0);
    }
    if (nearest > 0.0 && !(sum.w > 0.0)) {
        ProbeBox box = probeBoxes[nearestBox];
        sum = probeBoxIrradiance(box, position, normal, box.toUnit * vec4(position, 1.0));
    }
    return sum.w > 0.0 ? sum.rgb / sum.w : fallback;
}

// Radiance from direction r blurred as by a GGX lobe of that roughness. Every box that holds the point has a share, that fades over a
// tenth of its extent beyond its walls; what is missing is `fallback`. Among boxes the nearest probe has the say (1 / d^4): a farther one
// may stand behind a wall, where it sees another world.
vec3 reflectedRadiance(uint boxes, vec3 position, vec3 r, float roughness, vec3 fallback)
{
    vec4 sum = vec4(0.0);
    float covered = 0.0;
    for (uint i = 0u; i < boxes; ++i) {
        ReflectionBox box = reflectionBoxes[i];
        vec3 extent = max(box.upper - box.lower, vec3(1e-6));
        float share = boxShare((position - box.lower) / extent - 0.5, vec3(0.1));
        if (!(share > 0.0)) continue;
        vec3 apart = position - box.position;
        float near_ = share / (1e-4 + dot(apart, apart) * dot(apart, apart));
        // A point beyond a wall stretches the box to itself: what it mirrors is then continuous across the wall
        vec3 toward = boxParallax(position, r, min(box.lower, position), max(box.upper, position), box.position);
        sum += near_ * vec4(textureLod(reflections[i], toward, reflectionMip(roughness, box.mips)).rgb, 1.0);
        covered = max(covered, share);
    }
    return sum.w > 0.0 ? mix(fallback, sum.rgb / sum.w, covered) : fallback;
}

#endif
