// How much of a light reaches a point, by its shadow maps: 1 lit, 0 in shadow.
#ifndef AFTERGLOW_SHADOW_MAP_GLSL
#define AFTERGLOW_SHADOW_MAP_GLSL
#include "shaders/camera.h"
#include "shaders/shadow_map.h"

// Where a clip position lies in the map: xy atlas uv, z reference depth; z < 0: outside the map, hence lit.
vec3 shadowPoint(vec4 clip, vec2 scale, vec2 offset, float inset, vec2 lift)
{
    if (!(clip.w > 0.0)) return vec3(0.0, 0.0, -1.0); // behind a spot light
    vec3 ndc = clip.xyz / clip.w;
    vec2 uv = ndcToUv(ndc.xy);
    vec2 nearest = clamp(uv, vec2(inset), vec2(1.0 - inset));
    if (any(greaterThan(abs(uv - nearest), vec2(inset))) || ndc.z <= 0.0) return vec3(0.0, 0.0, -1.0);
    return vec3(nearest * scale + offset, min(ndc.z + ndc.z * lift.x + lift.y, 1.0));
}
vec3 shadowPoint(ShadowView map, vec3 world)
{
    return shadowPoint(map.worldToClip * vec4(world, 1.0), map.scale, map.offset, map.inset, map.lift);
}

// One comparison, blended over four texels by the hardware: for fog, whose steps blur it anyway.
float shadowTap(ShadowView map, sampler2DShadow atlas, vec3 world)
{
    vec3 p = shadowPoint(map, world);
    return p.z < 0.0 ? 1.0 : textureLod(atlas, p, 0.0);
}

// How much a map that follows the eye counts at a point: all within, nothing outside.
float cascadeShare(ShadowView map, vec3 world)
{
    vec2 ndc = abs((map.worldToClip * vec4(world, 1.0)).xy);
    return clamp((1.0 - max(ndc.x, ndc.y)) / kCascadeBlend, 0.0, 1.0);
}

// The map along a ray: clip space is affine in the distance, so a march needs no matrix at its steps.
struct ShadowRay {
    vec4 origin;
    vec4 direction;
    vec2 scale;
    vec2 offset;
    float inset;
    vec2 lift;
};
ShadowRay shadowRay(ShadowView map, vec3 origin, vec3 direction)
{
    return ShadowRay(map.worldToClip * vec4(origin, 1.0), map.worldToClip * vec4(direction, 0.0), map.scale, map.offset, map.inset, map.lift);
}
float shadowTap(ShadowRay ray, sampler2DShadow atlas, float t)
{
    vec3 p = shadowPoint(ray.origin + t * ray.direction, ray.scale, ray.offset, ray.inset, ray.lift);
    return p.z < 0.0 ? 1.0 : textureLod(atlas, p, 0.0);
}

// On a surface: four of them, half a texel apart to each side, a tent three texels wide. `face`: the geometric normal, or
// a guess of it; `off`: m, how far off its surface the point may lie; `toLight` as in shadowHeight.
float shadowFiltered(ShadowView map, sampler2DShadow atlas, vec3 world, vec3 normal, vec3 face, float off, vec3 toLight)
{
    vec4 clip = map.worldToClip * vec4(world, 1.0);
    clip += map.worldToClip * vec4(shadowLift(map, clip.w, normal, face, off, toLight), 0.0);
    vec3 p = shadowPoint(clip, map.scale, map.offset, map.inset, map.lift);
    if (p.z < 0.0) return 1.0;
    vec2 texel = 0.5 / vec2(textureSize(atlas, 0));
    float lit = textureLod(atlas, p + vec3(-texel, 0.0), 0.0) + textureLod(atlas, p + vec3(texel, 0.0), 0.0);
    lit += textureLod(atlas, p + vec3(-texel.x, texel.y, 0.0), 0.0) + textureLod(atlas, p + vec3(texel.x, -texel.y, 0.0), 0.0);
    return 0.25 * lit;
}

#endif
