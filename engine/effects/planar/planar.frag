#version 460
// What a mirror or still water sends to the eye of the world above it: the picture that an eye behind it sees, times what the surface
// reflects. Added to what lighting left of the surface, its matte base and the lights themselves.
#include "engine/effects/planar/planar.h"
#include "engine/effects/seen_surface.glsl"
#include "engine/effects/surface_push.h"
#include "shaders/material.glsl"

layout(constant_id = kPlanarRipples) const bool kRipples = false;
layout(constant_id = kPlanarLayers) const bool kLayers = false;

layout(push_constant, scalar) uniform Push { SurfacePush push; };
layout(set = 1, binding = 0, scalar) uniform Planar { PlanarFrame planar; };
layout(set = 1, binding = 1) uniform sampler2D mirroredRadiance;
layout(set = 1, binding = 2) uniform sampler2D mirroredDepth;

layout(location = 0) in vec3 worldNormal;
layout(location = 1) in vec4 worldTangent;
layout(location = 2) in vec2 uv0;
layout(location = 3) in vec2 uv1;
layout(location = 4) in vec4 vertexColor;
layout(location = 0) out vec4 radiance;
layout(location = 1) out vec4 reflectionLayer;

const uint kLooks = 2u; // for how far away the tilted direction ends
const float kSkyAway = 1e4; // m

// How far from the surface lies what the mirror's picture holds there.
float awayAt(vec3 position, vec2 uv)
{
    float depth = textureLod(mirroredDepth, uv, 0.0).r;
    return depth > 0.0 ? distance(position, worldFromDepth(uv, depth, planar.mirrorToWorld)) : kSkyAway;
}

void main()
{
    MaterialTexel m = sampleMaterial(push.material, uv0, uv1, vertexColor);
    Material material = materials[push.material];
    vec3 position = worldFromDepth(gl_FragCoord.xy / planar.size, gl_FragCoord.z, planar.clipToWorld);
    vec3 toEye = normalize(planar.eye.xyz - position * planar.eye.w);
    vec3 normal = shadingNormal(push.material, worldNormal, worldTangent, uv0, uv1);

    vec2 uv = mirroredUv(gl_FragCoord.xy, vec2(planar.corner), planar.mirrored);
    if (kRipples) {
        vec3 direction = rippledDirection(toEye, normal, planar.normal);
        vec2 smooth_ = uv;
        for (uint i = 0u; i < kLooks; ++i) uv = rippledUv(position, direction, awayAt(position, uv), planar.worldToMirror, smooth_);
        uv = clamp(uv, 0.5 / planar.mirrored, 1.0 - 0.5 / planar.mirrored);
    }
    vec3 wo = localEye(makeFrame(normal), toEye);
    Bsdf b = makeBsdf(material, vec4(m.baseColor, 1.0), vec2(m.roughness, m.metallic), m.transmission, gl_FrontFacing);
    float coverage = (material.flags & kMaterialAlphaBlend) != 0u ? clamp(m.alpha, 0.0, 1.0) : 1.0;
    vec3 sent = textureLod(mirroredRadiance, uv, 0.0).rgb * (interfaceReflectance(b, wo.z) * coverage);
    radiance = vec4(min(sent, vec3(0.5 * kHalfMax)), 0.0); // lighting has the other half: the sum is finite
    if (kLayers) reflectionLayer = radiance;
}
