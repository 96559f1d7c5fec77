#version 460
// What the air sends toward the eye: single scattering of every light the runtime draws, and of the light that the probes hold.
// Each step is integrated as if its source were constant (shaders/medium.h), so only the source's variation depends on the step count.
#include "engine/effects/fog/media.glsl"
#include "engine/effects/view_ray.h"
#include "shaders/light.h"
#include "shaders/phase.h"
#include "shaders/shadow_map.glsl"

layout(constant_id = kFogShadows) const bool kShadows = false;
layout(constant_id = kFogProbes) const bool kProbes = false;

layout(set = 1, binding = 0) uniform sampler2DShadow shadowAtlas;
layout(set = 1, binding = 1, scalar) readonly buffer ShadowViews { ShadowView shadowViews[]; };
layout(set = 1, binding = 2, scalar) readonly buffer ShadowFirst { int shadowFirst[]; };
layout(set = 1, binding = 3, scalar) readonly buffer Fog { FogFrame fog; };
layout(set = 1, binding = 4) uniform sampler2D depthTexture;

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 scattered; // rgb radiance, a distance of the surface, m

float lightReaches(uint light, uint type, vec3 lightPosition, vec3 position)
{
    if (!kShadows) return 1.0;
    int first = shadowFirst[light];
    if (first < 0) return 1.0;
    if (type == kLightPoint) first += int(shadowFace(position - lightPosition));
    return shadowTap(shadowViews[first], shadowAtlas, position);
}

// Radiance times phase function, over all directions.
vec3 source(vec3 position, vec3 direction, float g)
{
    vec3 ambient = fog.ambient;
    if (kProbes)
        for (uint i = 0u; i < fog.probeBoxes; ++i) {
            vec3 unitPosition = probeBoxes[i].toUnit * vec4(position, 1.0);
            if (any(greaterThan(abs(unitPosition), vec3(0.5)))) continue;
            // Texel centres are probes: (n - 1) cells between the first centre and the last
            vec3 n = vec3(probeBoxes[i].count);
            ambient = textureLod(meanRadiance[i], 0.5 + unitPosition * (n - 1.0) / n, 0.0).rgb;
        }
    vec3 sum = ambient; // a phase function integrates to 1
    for (uint i = 0u; i < fog.lights; ++i) {
        Light light = lights[i];
        light.radius = 0.0;
        light.sinAngle = 0.0;
        LightSample s = sampleLight(light, position, vec2(0.5));
        if (s.radiance == vec3(0.0)) continue;
        vec3 arriving = s.radiance * mediaTransmittance(fog.media, position, s.direction, s.distance);
        sum += arriving * (phaseHg(g, dot(direction, s.direction)) * lightReaches(i, light.type, light.position, position));
    }
    return sum;
}

void main()
{
    ivec2 pixel = min(ivec2(gl_FragCoord.xy) * int(fog.divisor), fog.size - 1);
    float depth = texelFetch(depthTexture, pixel, 0).r;
    ViewRay ray = viewRay((vec2(pixel) + 0.5) / vec2(fog.size), depth, fog.clipToWorld, fog.eye);

    float begin = kFloatMax, end = 0.0;
    for (uint i = 0u; i < fog.media; ++i) {
        Span s = boxSpan(ray.origin, ray.direction, media[i].lower, media[i].upper, ray.distance);
        if (!(s.end > s.begin)) continue;
        begin = min(begin, s.begin);
        end = max(end, opaqueEnd(s, extinction(media[i])));
    }
    scattered = vec4(0.0, 0.0, 0.0, min(ray.distance, kHalfMax));
    if (!(end > begin)) return;

    // Each of four neighbours stands on its own quarter of the step; the picture averages them
    ivec2 quarter = ivec2(gl_FragCoord.xy) & 1;
    float within = (float(quarter.x + 2 * (quarter.x ^ quarter.y)) + 0.5) * 0.25;
    float step_ = (end - begin) / float(fog.steps);
    vec3 through = vec3(1.0), sum = vec3(0.0);
    for (uint k = 0u; k < fog.steps; ++k) {
        float a = begin + float(k) * step_;
        vec3 sigmaS = vec3(0.0), sigmaT = vec3(0.0);
        float g = 0.0;
        for (uint i = 0u; i < fog.media; ++i) {
            Medium m = media[i];
            Span s = boxSpan(ray.origin, ray.direction, m.lower, m.upper, ray.distance);
            float share = spanOverlap(s, a, a + step_) / step_;
            sigmaS += share * m.scattering;
            sigmaT += share * extinction(m);
            g += share * m.g * (m.scattering.x + m.scattering.y + m.scattering.z);
        }
        float weight = sigmaS.x + sigmaS.y + sigmaS.z;
        if (weight > 0.0) {
            vec3 position = ray.origin + ray.direction * (a + within * step_);
            sum += through * stepInscatter(sigmaS, sigmaT, step_) * source(position, ray.direction, g / weight);
        }
        through *= transmittance(sigmaT, step_);
    }
    scattered.rgb = min(sum, vec3(kHalfMax));
}
