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

// Radiance from direction r blurred as by a GGX lobe of that roughness; what no box covers is `fallback`.
vec3 reflectedRadiance(uint boxes, vec3 position, vec3 r, float roughness, vec3 fallback)
{
    vec4 sum = vec4(0.0);
    float covered = 0.0;
    for (uint i = 0u; i < boxes; ++i) {
        ReflectionBox box = reflectionBoxes[i];
        vec2 influence = reflectionInfluence(box, position);
        if (influence.x > 0.0) {
            vec3 toward = reflectionDirection(box, position, r);
            sum += influence.y * vec4(textureLod(reflections[i], toward, reflectionMip(roughness, box.mips)).rgb, 1.0);
            covered = max(covered, influence.x);
        }
    }
    return sum.w > 0.0 ? mix(fallback, sum.rgb / sum.w, covered) : fallback;
}

#endif
