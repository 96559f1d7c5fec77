#version 460
// What the air sends toward the eye: single scattering of every light the runtime draws, and of the light that the probes hold.
// Medium by medium and light by light, so that a step reads no buffer: on a CPU a read costs as much as the rest of the step.
// Each step is integrated as if its source were constant (shaders/medium.h): only the source's variation depends on the step count.
#include "engine/effects/fog/fog.h"
#include "engine/effects/view_ray.h"
#include "shaders/light.h"
#include "shaders/media.glsl"
#include "shaders/phase.h"
#include "shaders/reflection.h"
#include "shaders/shadow_map.glsl"

layout(constant_id = kFogSunMaps) const uint kSunMaps = 0u;
layout(constant_id = kFogProbes) const bool kProbes = false;

layout(set = 1, binding = 0) uniform sampler2DShadow shadowAtlas;
layout(set = 1, binding = 1, scalar) readonly buffer ShadowViews { ShadowView shadowViews[]; };
layout(set = 1, binding = 2, scalar) readonly buffer ShadowFirst { int shadowFirst[]; };
layout(set = 1, binding = 3, scalar) uniform Fog { FogFrame fog; };
layout(set = 1, binding = 4) uniform sampler2D depthTexture;

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 scattered; // rgb radiance, a distance of the surface, m

// One medium along the ray, cut into equal steps.
struct March {
    uint medium;
    Medium m;
    vec3 sigmaT;
    Span span;
    float step_;      // m
    float within;     // where in its step the source is looked at, 0..1
    vec3 stepThrough; // transmittance of a step
    vec3 stepWeight;  // what a step adds for a unit source at its begin
};

March makeMarch(uint medium, ViewRay ray, uint steps, float within)
{
    March a;
    a.medium = medium;
    a.m = media[medium];
    a.sigmaT = extinctionOf(a.m);
    a.span = boxSpan(ray.origin, ray.direction, a.m.lower, a.m.upper, ray.distance);
    a.span.end = opaqueEnd(a.span, a.sigmaT);
    a.step_ = spanLength(a.span) / float(steps);
    a.within = within;
    a.stepThrough = transmittance(a.sigmaT, a.step_);
    a.stepWeight = stepInscatter(a.m.scattering, a.sigmaT, a.step_);
    return a;
}

// What the other media leave of light from t to the eye. Media rarely overlap or stand one behind the other; then this is free.
vec3 othersThrough(March a, ViewRay ray, float t)
{
    return fog.media > 1u ? mediaTransmittance(fog.media, a.medium, ray.origin, ray.direction, t) : vec3(1.0);
}

// The finest of a sun's maps that holds the point.
int sunMap(int first, vec3 position)
{
    int last = first + int(kSunMaps) - 1;
    while (first < last && !(cascadeShare(shadowViews[first], position) > 0.0)) ++first;
    return first;
}

vec3 scatteredFromLight(March a, ViewRay ray, uint index)
{
    Light light = lights[index];
    light.radius = 0.0; // as from its centre, or from the middle of its disc
    light.sinAngle = 0.0;
    bool sun = light.type == kLightDirectional;
    int first = kSunMaps > 0u ? shadowFirst[index] : -1;
    bool map = first >= 0 && (sun ? kSunMaps == 1u : light.type == kLightSpot);
    ShadowRay shadow;
    if (map) shadow = shadowRay(shadowViews[first], ray.origin, ray.direction);
    float sunPhase = phaseHg(a.m.g, -dot(ray.direction, light.direction));

    vec3 through = a.stepWeight, sum = vec3(0.0);
    for (uint k = 0u; k < fog.steps; ++k) {
        float t = a.span.begin + (float(k) + a.within) * a.step_;
        vec3 position = ray.origin + ray.direction * t;
        float lit = map ? shadowTap(shadow, shadowAtlas, t) : 1.0;
        if (kSunMaps > 0u && first >= 0 && !map) {
            int view = sun ? sunMap(first, position) : first + int(shadowFace(position - light.position));
            lit = shadowTap(shadowViews[view], shadowAtlas, position);
        }
        LightSample s = sampleLight(light, position, vec2(0.5));
        float phase = sun ? sunPhase : phaseHg(a.m.g, dot(ray.direction, s.direction));
        // On its way here the light crosses the medium too
        float crossed = min(boxExit(position, s.direction, a.m.lower, a.m.upper), s.distance);
        vec3 arriving = s.radiance * transmittance(a.sigmaT, crossed);
        if (fog.media > 1u) arriving *= mediaTransmittance(fog.media, a.medium, position, s.direction, s.distance) * othersThrough(a, ray, t);
        sum += through * arriving * (phase * lit);
        through *= a.stepThrough;
    }
    return sum;
}

// Mean radiance around a point, by the probes: of the box that holds it, or of the border of the nearest.
vec3 surrounding(vec3 position)
{
    vec3 mean = fog.ambient;
    float nearest = kFloatMax;
    for (uint i = 0u; i < fog.probeBoxes; ++i) {
        vec3 unitPosition = probeBoxes[i].toUnit * vec4(position, 1.0);
        vec3 outside = mat3(probeBoxes[i].toWorld) * max(abs(unitPosition) - 0.5, vec3(0.0));
        if (dot(outside, outside) >= nearest) continue;
        nearest = dot(outside, outside);
        vec3 n = vec3(probeBoxes[i].count); // texel centres are probes: n - 1 cells between the first and the last
        mean = textureLod(meanRadiance[i], 0.5 + clamp(unitPosition, -0.5, 0.5) * (n - 1.0) / n, 0.0).rgb;
    }
    return mean;
}

// Light from everywhere scatters as its mean: a phase function integrates to 1.
vec3 scatteredFromSurroundings(March a, ViewRay ray)
{
    vec3 through = vec3(1.0), sum = vec3(0.0);
    for (uint k = 0u; k < kFogSurroundings; ++k) {
        float t = a.span.begin + (float(k) + a.within) * a.step_;
        vec3 mean = kProbes ? surrounding(ray.origin + ray.direction * t) : fog.ambient;
        sum += through * a.stepWeight * mean * othersThrough(a, ray, t);
        through *= a.stepThrough;
    }
    return sum;
}

void main()
{
    ivec2 pixel = min(ivec2(gl_FragCoord.xy) * int(fog.divisor), fog.size - 1);
    float depth = texelFetch(depthTexture, pixel, 0).r;
    ViewRay ray = viewRay((vec2(pixel) + 0.5) / vec2(fog.size), depth, fog.clipToWorld, fog.eye);
    // Each of four neighbours stands on its own quarter of the step; the picture averages them
    ivec2 quarter = ivec2(gl_FragCoord.xy) & 1;
    float within = (float(quarter.x + 2 * (quarter.x ^ quarter.y)) + 0.5) * 0.25;

    vec3 sum = vec3(0.0);
    for (uint medium = 0u; medium < fog.media; ++medium) {
        March a = makeMarch(medium, ray, fog.steps, within);
        if (!(spanLength(a.span) > 0.0)) continue;
        for (uint i = 0u; i < fog.lights; ++i) sum += scatteredFromLight(a, ray, i);
        sum += scatteredFromSurroundings(makeMarch(medium, ray, kFogSurroundings, within), ray);
    }
    scattered = vec4(min(sum, vec3(kHalfMax)), min(ray.distance, kHalfMax));
}
