// Rays through the level by ray programs: the twin of shaders/trace.glsl, for where rays begin.
#ifndef AFTERGLOW_TRUTH_PROGRAMS_GLSL
#define AFTERGLOW_TRUTH_PROGRAMS_GLSL
#extension GL_EXT_ray_tracing : require
#include "engine/effects/truth/payload.glsl"
#include "shaders/met.glsl"

layout(set = 0, binding = 16) uniform accelerationStructureEXT rayLevel;
layout(location = 0) rayPayloadEXT Hit nearest;
layout(location = 1) rayPayloadEXT Passed passed;

// The nearest hit, alpha masks applied; a blended surface is met by chance, as often as its alpha says.
Hit closestHit(Ray ray)
{
    traceRayEXT(rayLevel, gl_RayFlagsNoneEXT, 0xffu, kRayNearest, kRayKinds, kRayNearest, ray.origin, 0.0, ray.direction, ray.far, 0);
    return nearest;
}

// Fraction of light that passes along the ray up to ray.far: 0 behind anything opaque.
vec3 transmittance(Ray ray)
{
    uint flags = gl_RayFlagsTerminateOnFirstHitEXT | gl_RayFlagsSkipClosestHitShaderEXT;
    passed = Passed(vec3(1.0), 0u);
    traceRayEXT(rayLevel, flags, 0xffu, kRayShadow, kRayKinds, kRayShadow, ray.origin, 0.0, ray.direction, ray.far, 1);
    return passed.arrived != 0u ? passed.share : vec3(0.0);
}

#endif
