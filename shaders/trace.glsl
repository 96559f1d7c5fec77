// Rays through the level by ray query: the runtime's twin of baker/world.hpp. For passes of their own: a device without ray queries
// compiles none of this.
#ifndef AFTERGLOW_TRACE_GLSL
#define AFTERGLOW_TRACE_GLSL
#extension GL_EXT_ray_query : require
#include "shaders/met.glsl"

layout(set = 0, binding = 16) uniform accelerationStructureEXT rayLevel;

// A loop over candidates asks it of each once more. Experiment: without it Mesa's lavapipe 25.0 crashes at closestHit() in the gallery, on
// reading a candidate's instance, even where every triangle is opaque; it seems to let rays that are done into the loop of their
// neighbours.
#define HAS_CANDIDATE(query) (rayQueryGetIntersectionTypeEXT(query, false) == gl_RayQueryCandidateIntersectionTriangleEXT)

// Fraction of light that passes along the ray up to ray.far: 0 behind anything opaque.
vec3 transmittance(Ray ray)
{
    rayQueryEXT query;
    uint flags = gl_RayFlagsTerminateOnFirstHitEXT | (kFiltered ? gl_RayFlagsNoneEXT : gl_RayFlagsOpaqueEXT);
    rayQueryInitializeEXT(query, rayLevel, flags, 0xffu, ray.origin, 0.0, ray.direction, ray.far);
    vec3 passed = vec3(1.0);
    while (rayQueryProceedEXT(query)) {
        if (!kFiltered || !HAS_CANDIDATE(query)) continue;
        uint triangle = uint(rayQueryGetIntersectionInstanceCustomIndexEXT(query, false) + rayQueryGetIntersectionPrimitiveIndexEXT(query, false));
        passed *= passesOn(triangle, rayQueryGetIntersectionBarycentricsEXT(query, false), ray.direction);
        if (passed == vec3(0.0)) rayQueryConfirmIntersectionEXT(query);
    }
    return rayQueryGetIntersectionTypeEXT(query, true) == gl_RayQueryCommittedIntersectionNoneEXT ? passed : vec3(0.0);
}

// The nearest hit, alpha masks applied; a blended surface is met by chance, as often as its alpha says.
Hit closestHit(Ray ray)
{
    rayQueryEXT query;
    uint flags = kFiltered ? gl_RayFlagsNoneEXT : gl_RayFlagsOpaqueEXT;
    rayQueryInitializeEXT(query, rayLevel, flags, 0xffu, ray.origin, 0.0, ray.direction, ray.far);
    while (rayQueryProceedEXT(query)) {
        if (!kFiltered || !HAS_CANDIDATE(query)) continue;
        uint triangle = uint(rayQueryGetIntersectionInstanceCustomIndexEXT(query, false) + rayQueryGetIntersectionPrimitiveIndexEXT(query, false));
        if (isMet(triangle, rayQueryGetIntersectionBarycentricsEXT(query, false), ray.direction)) rayQueryConfirmIntersectionEXT(query);
    }
    if (rayQueryGetIntersectionTypeEXT(query, true) == gl_RayQueryCommittedIntersectionNoneEXT) return Hit(kRayFar, 0u, vec2(0.0));
    uint triangle = uint(rayQueryGetIntersectionInstanceCustomIndexEXT(query, true) + rayQueryGetIntersectionPrimitiveIndexEXT(query, true));
    return Hit(rayQueryGetIntersectionTEXT(query, true), triangle, rayQueryGetIntersectionBarycentricsEXT(query, true));
}

#endif
