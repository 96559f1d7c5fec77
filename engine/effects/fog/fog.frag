#version 460
// The picture behind the air: dimmed in closed form at every pixel, plus what the march scattered at a lower resolution, taken from those
// of its neighbours that saw a surface at a like distance.
#include "engine/effects/fog/fog.h"
#include "engine/effects/view_ray.h"
#include "shaders/media.glsl"

layout(set = 1, binding = 0, scalar) uniform Fog { FogFrame fog; };
layout(set = 1, binding = 1) uniform sampler2D depthTexture;
layout(set = 1, binding = 2) uniform sampler2D radianceTexture;
layout(set = 1, binding = 3) uniform sampler2D scatteredTexture;

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 radiance;

// Four neighbours, one of each quarter of the step: equal shares where they lie on one surface.
vec3 scatteredHere(ivec2 pixel, float distance_)
{
    ivec2 last = textureSize(scatteredTexture, 0) - 1;
    ivec2 corner = (pixel - int(fog.divisor) / 2) / int(fog.divisor);
    vec4 sum = vec4(0.0);
    for (int k = 0; k < 4; ++k) {
        vec4 texel = texelFetch(scatteredTexture, clamp(corner + ivec2(k & 1, k >> 1), ivec2(0), last), 0);
        float apart = abs(texel.a - distance_) / max(distance_, 1e-3);
        float weight = 1.0 / (1e-3 + apart * apart);
        sum += weight * vec4(texel.rgb, 1.0);
    }
    return sum.rgb / sum.a;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ViewRay ray = viewRay(uv, texelFetch(depthTexture, pixel, 0).r, fog.clipToWorld, fog.eye);
    vec4 behind = texelFetch(radianceTexture, pixel, 0);
    vec3 through = mediaTransmittance(fog.media, kEveryMedium, ray.origin, ray.direction, ray.distance);
    radiance = vec4(min(behind.rgb * through + scatteredHere(pixel, min(ray.distance, kHalfMax)), vec3(kHalfMax)), behind.a);
}
