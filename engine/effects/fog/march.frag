#version 460
// What the air sends toward the eye: single scattering of every light the runtime draws, and of the light that the probes hold.
// Medium by medium and light by light, so that a step reads no buffer: on a CPU a read costs as much as the rest of the step.
#include "engine/effects/fog/march_lamp.glsl"
#include "engine/effects/fog/march_sun.glsl"
#include "engine/effects/fog/march_surroundings.glsl"

layout(constant_id = kFogMemory) const bool kMemory = false;

layout(set = 1, binding = 4) uniform sampler2D depthTexture;
layout(set = 1, binding = 5) uniform sampler2D before; // the march of the frames before

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 scattered; // rgb radiance, a distance of the surface, m

// What the frames before knew of this air: looked up where the light came from on the whole, unless another surface stood behind it then.
vec3 remembered(vec3 now, ViewRay ray, float from)
{
    if (!kMemory) return now;
    vec4 clip = fog.worldToClipBefore * vec4(ray.origin + ray.direction * from, 1.0);
    vec2 at = ndcToUv(clip.xy / clip.w);
    if (!(fog.share < 1.0 && clip.w > 0.0 && all(equal(at, clamp(at, 0.0, 1.0))))) return now;
    float surface = min(ray.distance, kHalfMax);
    if (surface < kHalfMax && fog.eye.w > 0.0) surface = length(ray.origin + ray.direction * ray.distance - fog.eyeBefore.xyz);
    vec2 texel = (at * vec2(fog.size) - 0.5 - float(fog.divisor / 2u)) / float(fog.divisor);
    vec2 corner = floor(texel), f = texel - corner;
    vec4 sum = vec4(0.0);
    for (int k = 0; k < 4; ++k) {
        ivec2 offset = ivec2(k & 1, k >> 1);
        vec4 old = texelFetch(before, clamp(ivec2(corner) + offset, ivec2(0), textureSize(before, 0) - 1), 0);
        vec2 share = mix(1.0 - f, f, vec2(offset));
        if (abs(old.a - surface) <= kFogSameSurface * surface) sum += share.x * share.y * vec4(old.rgb, 1.0);
    }
    return sum.a > 0.05 ? mix(sum.rgb / sum.a, now, fog.share) : now;
}

void main()
{
    ivec2 pixel = min(ivec2(gl_FragCoord.xy) * int(fog.divisor) + int(fog.divisor / 2u), fog.size - 1);
    float depth = texelFetch(depthTexture, pixel, 0).r;
    ViewRay ray = viewRay((vec2(pixel) + 0.5) / vec2(fog.size), depth, fog.clipToWorld, fog.eye);
    // Each of four neighbours stands on its own quarter of the step, which the picture averages; frame by frame they move on
    ivec2 quarter = ivec2(gl_FragCoord.xy) & 1;
    float within = fract((float(quarter.x + 2 * (quarter.x ^ quarter.y)) + 0.5) * 0.25 + fog.shift);

    Scattered sum = Scattered(vec3(0.0), 0.0);
    for (uint medium = 0u; medium < kMedia; ++medium) {
        Crossing c;
        c.medium = medium;
        c.m = media[medium];
        c.sigmaT = extinctionOf(c.m);
        c.span = mediumSpan(Air(kMedia), c.m, ray.origin, ray.direction, ray.distance);
        c.span.end = opaqueEnd(c.span, c.sigmaT);
        if (!(spanLength(c.span) > 0.0) || c.m.scattering == vec3(0.0)) continue;
        Scattered some = scatteredFromSurroundings(c, ray, within);
        sum.radiance += some.radiance;
        sum.moment += some.moment;
        for (uint i = 0u; i < kLights; ++i) {
            Light light = lights[i];
            int first = kSunMaps > 0u ? shadowFirst[i] : -1;
            some = light.type == kLightDirectional ? scatteredFromSun(c, ray, light, first, within)
                                                   : scatteredFromLamp(c, ray, light, first, within);
            sum.radiance += some.radiance;
            sum.moment += some.moment;
        }
    }
    float from = sum.radiance.g > 0.0 ? min(sum.moment / sum.radiance.g, ray.distance) : min(ray.distance, kHalfMax);
    vec3 lasting = remembered(min(sum.radiance, vec3(kHalfMax)), ray, from);
    scattered = vec4(lasting, min(ray.distance, kHalfMax));
}
