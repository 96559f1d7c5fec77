// How much of a light reaches a point, by its shadow maps: 1 lit, 0 in shadow.
#ifndef AFTERGLOW_SHADOW_MAP_GLSL
#define AFTERGLOW_SHADOW_MAP_GLSL
#include "shaders/camera.h"
#include "shaders/shadow_map.h"

// Where the point lies in the map: xy atlas uv, z reference depth; z < 0: outside the map, hence lit.
vec3 shadowPoint(ShadowView map, vec3 world)
{
    vec4 clip = map.worldToClip * vec4(world, 1.0);
    if (!(clip.w > 0.0)) return vec3(0.0, 0.0, -1.0); // behind a spot light
    vec3 ndc = clip.xyz / clip.w;
    vec2 uv = ndcToUv(ndc.xy);
    vec2 nearest = clamp(uv, vec2(map.inset), vec2(1.0 - map.inset));
    if (any(greaterThan(abs(uv - nearest), vec2(map.inset))) || ndc.z <= 0.0) return vec3(0.0, 0.0, -1.0);
    return vec3(nearest * map.scale + map.offset, min(ndc.z, 1.0));
}

// One comparison, blended over four texels by the hardware: for fog, whose steps blur it anyway.
float shadowTap(ShadowView map, sampler2DShadow atlas, vec3 world)
{
    vec3 p = shadowPoint(map, world);
    return p.z < 0.0 ? 1.0 : textureLod(atlas, p, 0.0);
}

// Four of them, half a texel apart to each side: a tent three texels wide.
float shadowFiltered(ShadowView map, sampler2DShadow atlas, vec3 world)
{
    vec3 p = shadowPoint(map, world);
    if (p.z < 0.0) return 1.0;
    vec2 texel = 0.5 / vec2(textureSize(atlas, 0));
    float lit = textureLod(atlas, p + vec3(-texel, 0.0), 0.0) + textureLod(atlas, p + vec3(texel, 0.0), 0.0);
    lit += textureLod(atlas, p + vec3(-texel.x, texel.y, 0.0), 0.0) + textureLod(atlas, p + vec3(texel.x, -texel.y, 0.0), 0.0);
    return 0.25 * lit;
}

#endif
