// The march through the air, step by step: what each kind of light needs to know of a medium along the ray.
#ifndef AFTERGLOW_FOG_MARCH_GLSL
#define AFTERGLOW_FOG_MARCH_GLSL
#include "engine/effects/fog/fog.h"
#include "engine/effects/view_ray.h"
#include "shaders/light.h"
#include "shaders/media.glsl"
#include "shaders/phase.h"
#include "shaders/shadow_map.glsl"

layout(constant_id = kFogSunMaps) const uint kSunMaps = 0u;
layout(constant_id = kFogProbes) const uint kProbes = 0u;
layout(constant_id = kFogLights) const uint kLights = 0u;
layout(constant_id = kFogMedia) const uint kMedia = 0u;

layout(set = 1, binding = 0) uniform sampler2DShadow shadowAtlas;
layout(set = 1, binding = 1, scalar) readonly buffer ShadowViews { ShadowView shadowViews[]; };
layout(set = 1, binding = 2, scalar) readonly buffer ShadowFirst { int shadowFirst[]; };
layout(set = 1, binding = 3, scalar) uniform Fog { FogFrame fog; };

// One medium along the ray.
struct Crossing {
    uint medium;
    Medium m;
    vec3 sigmaT;
    Span span;
};

// What was scattered, and from how far on the whole: the mean distance weighted by the green channel, times green.
struct Scattered {
    vec3 radiance;
    float moment;
};

// Optical depth of every other medium. Media rarely overlap or stand one behind the other; one alone pays nothing.
vec3 othersDepth(uint medium, vec3 origin, vec3 direction, float limit)
{
    vec3 depth = vec3(0.0);
    Air air = Air(kMedia);
    if (kMedia > 1u)
        for (uint i = 0u; i < kMedia; ++i)
            if (i != medium) depth += opticalDepth(extinctionOf(media[i]), spanLength(mediumSpan(air, media[i], origin, direction, limit)));
    return depth;
}
// `way`: m inside the medium, which counts from its border: a wall of fog is thinner than a float's step at a few metres.
vec3 depthToEye(Crossing c, ViewRay ray, float way)
{
    return opticalDepth(c.sigmaT, way) + othersDepth(c.medium, ray.origin, ray.direction, c.span.begin + way);
}

#endif
