#version 460
// What the air sends toward the eye: single scattering of every light the runtime draws, and of the light that the probes hold.
// Medium by medium and light by light, so that a step reads no buffer: on a CPU a read costs as much as the rest of the step.
// Parallel light: steps of equal length, each integrated as if the optical depth to the eye and to the light ran linearly along it, which
// it does. A lamp: steps of equal angle about it. What is left for the step count is the shadow's border.
#include "engine/effects/fog/fog.h"
#include "engine/effects/view_ray.h"
#include "shaders/light.h"
#include "shaders/media.glsl"
#include "shaders/phase.h"
#include "shaders/shadow_map.glsl"

layout(constant_id = kFogSunMaps) const uint kSunMaps = 0u;
layout(constant_id = kFogProbes) const bool kProbes = false;
layout(constant_id = kFogMemory) const bool kMemory = false;

layout(set = 1, binding = 0) uniform sampler2DShadow shadowAtlas;
layout(set = 1, binding = 1, scalar) readonly buffer ShadowViews { ShadowView shadowViews[]; };
layout(set = 1, binding = 2, scalar) readonly buffer ShadowFirst { int shadowFirst[]; };
layout(set = 1, binding = 3, scalar) uniform Fog { FogFrame fog; };
layout(set = 1, binding = 4) uniform sampler2D depthTexture;
layout(set = 1, binding = 5) uniform sampler2D before; // the march of the frames before

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 scattered; // rgb radiance, a distance of the surface, m

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
    Air air = Air(fog.media);
    if (fog.media > 1u)
        for (uint i = 0u; i < fog.media; ++i)
            if (i != medium) depth += opticalDepth(extinctionOf(media[i]), spanLength(mediumSpan(air, media[i], origin, direction, limit)));
    return depth;
}
// `way`: m inside the medium, which counts from its border: a wall of fog is thinner than a float's step at a few metres.
vec3 depthToEye(Crossing c, ViewRay ray, float way)
{
    return opticalDepth(c.sigmaT, way) + othersDepth(c.medium, ray.origin, ray.direction, c.span.begin + way);
}

// Where parallel light enters the medium on its way to a point of the ray: the distances to the box's faces are affine in the way.
struct Entry {
    vec3 toLight;
    vec3 faces; // m, from where the ray enters
    vec3 slope;
};
Entry makeEntry(Crossing c, ViewRay ray, vec3 toLight)
{
    Entry e = Entry(toLight, vec3(kFloatMax), vec3(0.0));
    vec3 position = ray.origin + ray.direction * c.span.begin;
    for (int a = 0; a < 3; ++a) {
        if (toLight[a] == 0.0) continue;
        float face = toLight[a] > 0.0 ? c.m.upper[a] : c.m.lower[a], apart = face - position[a];
        // What the ray and the light enter by alike is no rounding apart
        e.faces[a] = abs(apart) > kFogRounding * (abs(face) + c.span.begin) ? apart / toLight[a] : 0.0;
        e.slope[a] = -ray.direction[a] / toLight[a];
    }
    return e;
}
float crossed(Crossing c, Entry e, vec3 position, float way)
{
    vec3 to = e.faces + e.slope * way;
    Span s = Span(0.0, max(min(min(to.x, to.y), to.z), 0.0));
    for (uint i = 0u; i < c.m.planeCount; ++i) s = planeSpan(s, position, e.toLight, mediumPlanes[c.m.firstPlane + i]);
    return spanLength(s);
}

// The finest of a sun's maps that holds the point.
int sunMap(int first, vec3 position)
{
    int last = first + int(kSunMaps) - 1;
    while (first < last && !(cascadeShare(shadowViews[first], position) > 0.0)) ++first;
    return first;
}

Scattered scatteredFromSun(Crossing c, ViewRay ray, Light light, int first, float within)
{
    bool oneMap = first >= 0 && kSunMaps == 1u;
    ShadowRay shadow;
    if (oneMap) shadow = shadowRay(shadowViews[first], ray.origin, ray.direction);
    float step_ = spanLength(c.span) / float(fog.steps);
    vec3 toLight = -light.direction;
    Entry entry = makeEntry(c, ray, toLight);
    Scattered s = Scattered(vec3(0.0), 0.0);
    vec3 tau0, e0;
    for (uint k = 0u; k <= fog.steps; ++k) {
        float way = float(k) * step_;
        vec3 border = ray.origin + ray.direction * (c.span.begin + way);
        vec3 depth = depthToEye(c, ray, way) + opticalDepth(c.sigmaT, crossed(c, entry, border, way));
        depth += othersDepth(c.medium, border, toLight, kFloatMax);
        vec3 tau1 = min(depth, vec3(kFogBlack)), e1 = exp(-tau1);
        if (k > 0u) {
            // The shadow is asked for where the share `within` of the step's light lies before, so that shifts average to its integral
            float t = c.span.begin + way - step_ * (1.0 - shareOfStep(tau1.g - tau0.g, within));
            float lit = oneMap ? shadowTap(shadow, shadowAtlas, t) : 1.0;
            if (first >= 0 && !oneMap) {
                vec3 position = ray.origin + ray.direction * t;
                lit = shadowTap(shadowViews[sunMap(first, position)], shadowAtlas, position);
            }
            vec3 arriving = lit * meanOfExponentials(tau0, tau1, e0, e1);
            s.radiance += arriving;
            s.moment += arriving.g * t;
        }
        tau0 = tau1;
        e0 = e1;
    }
    vec3 unit = light.intensity * c.m.scattering * (step_ * phaseHg(c.m.g, -dot(ray.direction, light.direction)));
    return Scattered(s.radiance * unit, s.moment * unit.g);
}

// Nearer to the ray than its radius a lamp shines as from there; nor nearer than the mean of 1/h over a texel, which is 4 asinh(1) / edge.
float nearestLamp(ViewRay ray, Light light)
{
    float edge = fog.texel * (fog.eye.w > 0.0 ? length(light.position - ray.origin) : 1.0);
    return max(max(light.radius, kMinLightDistance), edge / 3.5255);
}

Scattered scatteredFromLamp(Crossing c, ViewRay ray, Light light, int first, float within)
{
    LampMarch m = lampMarch(ray.origin, ray.direction, c.span, light.position, nearestLamp(ray, light), float(fog.steps));
    bool spot = light.type == kLightSpot;
    ShadowRay shadow;
    if (first >= 0 && spot) shadow = shadowRay(shadowViews[first], ray.origin, ray.direction);
    Air air = Air(fog.media);
    bool inside = spanLength(mediumSpan(air, c.m, light.position, vec3(0.0), 1.0)) > 0.0; // the lamp, in the medium
    float angle = m.first + within * m.step_;
    vec2 turn = vec2(cos(m.step_), sin(m.step_)), at = vec2(cos(angle), sin(angle)); // cosine and sine, turned step by step
    Scattered s = Scattered(vec3(0.0), 0.0);
    for (uint k = 0u; k < fog.steps; ++k) {
        float cosine = max(at.x, 1e-6), sine = at.y;
        float t = clamp(m.along + m.h * sine / cosine, c.span.begin, c.span.end);
        vec3 position = ray.origin + ray.direction * t;
        vec3 offset = light.position - position;
        float distance_ = length(offset);
        vec3 toLight = distance_ > 0.0 ? offset / distance_ : -ray.direction;
        float lit = 1.0;
        if (first >= 0)
            lit = spot ? shadowTap(shadow, shadowAtlas, t)
                       : shadowTap(shadowViews[first + int(shadowFace(position - light.position))], shadowAtlas, position);
        float way = max(distance_ - light.radius, 0.0); // from the lamp's surface
        float own = inside ? way : spanLength(mediumSpan(air, c.m, position, toLight, way));
        vec3 depth = depthToEye(c, ray, t - c.span.begin) + opticalDepth(c.sigmaT, own) + othersDepth(c.medium, position, toLight, way);
        vec3 arriving = lightIntensity(light, toLight, distance_) * exp(-min(depth, vec3(kFogBlack)));
        float g = c.m.g;
        if (light.radius > 0.0) {
            arriving *= sphereFluence(light.radius, distance_) * m.h * m.h / (cosine * cosine); // in place of a point's 1/r^2
            g *= sphereMeanCosine(light.radius, distance_);
        }
        arriving *= phaseHg(g, -sine) * lit; // the cosine between ray and light is -sine
        s.radiance += arriving;
        s.moment += arriving.g * t;
        at = vec2(at.x * turn.x - at.y * turn.y, at.y * turn.x + at.x * turn.y);
    }
    vec3 unit = c.m.scattering * (m.step_ / m.h);
    return Scattered(s.radiance * unit, s.moment * unit.g);
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
Scattered scatteredFromSurroundings(Crossing c, ViewRay ray, float within)
{
    float step_ = spanLength(c.span) / float(kFogSurroundings);
    Scattered s = Scattered(vec3(0.0), 0.0);
    vec3 tau0 = min(depthToEye(c, ray, 0.0), vec3(kFogBlack)), e0 = exp(-tau0);
    for (uint k = 0u; k < kFogSurroundings; ++k) {
        float way = float(k + 1u) * step_, t = c.span.begin + way + (within - 1.0) * step_;
        vec3 tau1 = min(depthToEye(c, ray, way), vec3(kFogBlack)), e1 = exp(-tau1);
        vec3 mean = kProbes ? surrounding(ray.origin + ray.direction * t) : fog.ambient;
        vec3 arriving = mean * meanOfExponentials(tau0, tau1, e0, e1);
        s.radiance += arriving;
        s.moment += arriving.g * t;
        tau0 = tau1;
        e0 = e1;
    }
    return Scattered(s.radiance * c.m.scattering * step_, s.moment * c.m.scattering.g * step_);
}

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
    for (uint medium = 0u; medium < fog.media; ++medium) {
        Crossing c;
        c.medium = medium;
        c.m = media[medium];
        c.sigmaT = extinctionOf(c.m);
        c.span = mediumSpan(Air(fog.media), c.m, ray.origin, ray.direction, ray.distance);
        c.span.end = opaqueEnd(c.span, c.sigmaT);
        if (!(spanLength(c.span) > 0.0) || c.m.scattering == vec3(0.0)) continue;
        Scattered some = scatteredFromSurroundings(c, ray, within);
        sum.radiance += some.radiance;
        sum.moment += some.moment;
        for (uint i = 0u; i < fog.lights; ++i) {
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
