#version 460
// The parts of the picture behind the air, dimmed as the picture is, and what the air adds as a part of its own.
#include "engine/effects/fog/scattered.glsl"
#include "engine/effects/view_ray.h"
#include "shaders/media.glsl"

layout(constant_id = kFogEmission) const bool kEmission = false;
layout(constant_id = kFogMedia) const uint kMedia = 0u;

layout(set = 1, binding = 0, scalar) uniform Fog { FogFrame fog; };
layout(set = 1, binding = 1) uniform sampler2D depthTexture;
layout(set = 1, binding = 2) uniform sampler2D scatteredTexture;
layout(set = 1, binding = 3) uniform sampler2D directTexture;
layout(set = 1, binding = 4) uniform sampler2D indirectTexture;
layout(set = 1, binding = 5) uniform sampler2D reflectionTexture;
layout(set = 1, binding = 6) uniform sampler2D emissionTexture;

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 reflectionLayer; // the order of writeAll() (engine/effects/layers.hpp)
layout(location = 1) out vec4 directLayer;
layout(location = 2) out vec4 indirectLayer;
layout(location = 3) out vec4 emissionLayer;
layout(location = 4) out vec4 fogLayer;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ViewRay ray = viewRay(uv, texelFetch(depthTexture, pixel, 0).r, fog.clipToWorld, fog.eye);
    Air air = Air(kMedia);
    vec4 through = vec4(mediaTransmittance(air, ray.origin, ray.direction, ray.distance), 1.0);
    directLayer = through * texelFetch(directTexture, pixel, 0);
    indirectLayer = through * texelFetch(indirectTexture, pixel, 0);
    reflectionLayer = through * texelFetch(reflectionTexture, pixel, 0);
    emissionLayer = through * texelFetch(emissionTexture, pixel, 0);
    vec3 sum = scatteredHere(scatteredTexture, fog.divisor, pixel, min(ray.distance, kHalfMax));
    if (kEmission) sum += mediaEmission(air, ray.origin, ray.direction, ray.distance);
    fogLayer = vec4(min(sum, vec3(kHalfMax)), 1.0);
}
