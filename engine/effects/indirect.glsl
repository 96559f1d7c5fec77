// What the bake says of the light at a point: irradiance / pi from lightmaps or probes, and what a glossy surface mirrors.
#ifndef AFTERGLOW_INDIRECT_GLSL
#define AFTERGLOW_INDIRECT_GLSL
#include "shaders/bindings.glsl"
#include "shaders/gbuffer.h"
#include "shaders/lightmap.h"
#include "shaders/probes.glsl"
#include "shaders/reflection.h"

// The uniform index first: a divergent one costs three times as much on a CPU.
vec3 lightmapValue(uint pages, uint page, vec2 uv)
{
    if (pages == 1u) return textureLod(lightmaps[0], uv, 0.0).rgb;
    return textureLod(lightmaps[nonuniformEXT(page)], uv, 0.0).rgb;
}

// Where that light comes from: as many pages more (shaders/lightmap.h).
vec4 lightmapDirection(uint pages, uint page, vec2 uv)
{
    if (pages == 1u) return textureLod(lightmaps[1], uv, 0.0);
    return textureLod(lightmaps[nonuniformEXT(pages + page)], uv, 0.0);
}

// What a box has to say at a point. x: its share, 1 within, that fades over a tenth of its extent beyond its walls. y: its weight among
// boxes; the nearest probe has the say (1 / d^4): a farther one may stand behind a wall, where it sees another world.
vec2 reflectionInfluence(ReflectionBox box, vec3 position)
{
    vec3 extent = max(box.upper - box.lower, vec3(1e-6));
    float share = boxShare((position - box.lower) / extent - 0.5, vec3(0.1));
    vec3 apart = position - box.position;
    return vec2(share, share / (1e-4 + dot(apart, apart) * dot(apart, apart)));
}

// Radiance from direction r blurred as by a GGX lobe of that roughness; what no box covers is `fallback`.
vec3 reflectedRadiance(uint boxes, vec3 position, vec3 r, float roughness, vec3 fallback)
{
    vec4 sum = vec4(0.0);
    float covered = 0.0;
    for (uint i = 0u; i < boxes; ++i) {
        ReflectionBox box = reflectionBoxes[i];
        vec2 influence = reflectionInfluence(box, position);
        if (influence.x > 0.0) {
            // A point beyond a wall stretches the box to itself: what it mirrors is then continuous across the wall
            vec3 toward = boxParallax(position, r, min(box.lower, position), max(box.upper, position), box.position);
            sum += influence.y * vec4(textureLod(reflections[i], toward, reflectionMip(roughness, box.mips)).rgb, 1.0);
            covered = max(covered, influence.x);
        }
    }
    return sum.w > 0.0 ? mix(fallback, sum.rgb / sum.w, covered) : fallback;
}

#endif
