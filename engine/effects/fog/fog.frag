#version 460
// The picture behind the air: dimmed in closed form at every pixel, plus what the air sends out by itself, plus what the march scattered at
// a lower resolution, taken from those of its neighbours that saw a surface at a like distance.
#include "engine/effects/fog/scattered.glsl"
#include "engine/effects/view_ray.h"
#include "shaders/media.glsl"

layout(constant_id = kFogEmission) const bool kEmission = false;
layout(constant_id = kFogMedia) const uint kMedia = 0u;

layout(set = 1, binding = 0, scalar) uniform Fog { FogFrame fog; };
layout(set = 1, binding = 1) uniform sampler2D depthTexture;
layout(set = 1, binding = 2) uniform sampler2D radianceTexture;
layout(set = 1, binding = 3) uniform sampler2D scatteredTexture;

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 radiance;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ViewRay ray = viewRay(uv, texelFetch(depthTexture, pixel, 0).r, fog.clipToWorld, fog.eye);
    vec4 behind = texelFetch(radianceTexture, pixel, 0);
    Air air = Air(kMedia);
    vec3 sum = behind.rgb * mediaTransmittance(air, ray.origin, ray.direction, ray.distance);
    sum += scatteredHere(scatteredTexture, fog.divisor, pixel, min(ray.distance, kHalfMax));
    if (kEmission) sum += mediaEmission(air, ray.origin, ray.direction, ray.distance);
    radiance = vec4(min(sum, vec3(kHalfMax)), behind.a);
}
