// The light that leaves a surface toward the eye: direct light through the law of the surface, indirect light as the bake says. Shared by
// the passes over the G-buffer and by the one that draws clear surfaces. All begin with the same bindings of set 1 (shading.cpp).
#ifndef AFTERGLOW_SHADING_GLSL
#define AFTERGLOW_SHADING_GLSL
#include "engine/effects/indirect.glsl"
#include "engine/effects/interfaces.glsl"
#include "engine/effects/shading.h"
#include "engine/effects/view_ray.h"
#include "shaders/light.h"
#include "shaders/media.glsl"
#include "shaders/visibility.h"
#include "shaders/shadow_map.glsl"

layout(constant_id = kLightingLightmaps) const uint kLightmapPages = 0u;
layout(constant_id = kLightingProbes) const uint kProbes = 0u;
layout(constant_id = kLightingReflections) const uint kReflections = 0u;
layout(constant_id = kLightingLights) const uint kLights = 0u;
layout(constant_id = kLightingSunMaps) const uint kSunMaps = 0u;
layout(constant_id = kLightingMedia) const uint kMedia = 0u;
layout(constant_id = kLightingOcclusion) const bool kOcclusion = false;
layout(constant_id = kLightingDirectional) const bool kDirectional = false;

layout(set = 1, binding = 0) uniform sampler2DShadow shadowAtlas;
layout(set = 1, binding = 1, scalar) readonly buffer ShadowViews { ShadowView shadowViews[]; };
layout(set = 1, binding = 2, scalar) readonly buffer ShadowFirst { int shadowFirst[]; }; // by light: its first view; -1: it casts none
layout(set = 1, binding = 3, scalar) readonly buffer Lighting { LightingFrame lighting; };

struct ShadedPoint {
    vec3 position; // world
    vec3 normal;   // shading normal, on the side of the eye
    bool bent;     // by a normal map
    vec3 face;     // geometric normal, on the side of the eye; across a silhouette a guess
    float off;     // m, how far off its surface the position may lie
    vec3 toEye;    // unit
    float roughness;
    vec2 lightmapUv;
    uint page;
    float open;    // visibility of the light from everywhere, 1 = open
    uint mirrored; // 1: what its interfaces mirror is added later, sharp
};

float mapReaches(ShadowView map, ShadedPoint p, vec3 toLight)
{
    return shadowFiltered(map, shadowAtlas, p.position, p.normal, p.face, p.off, toLight);
}

// By the finest map that holds the point, blended into the next at its rim; the last holds the whole level.
float sunReaches(int first, ShadedPoint p, vec3 toLight)
{
    float lit = 0.0, rest = 1.0;
    for (int last = first + int(kSunMaps) - 1; first < last && rest > 0.0; ++first) {
        float share = rest * cascadeShare(shadowViews[first], p.position);
        if (share > 0.0) lit += share * mapReaches(shadowViews[first], p, toLight);
        rest -= share;
    }
    return rest > 0.0 ? lit + rest * mapReaches(shadowViews[first], p, toLight) : lit;
}

// Share of a light that the shadow maps let reach the point.
float mapReaches(uint index, Light light, ShadedPoint p)
{
    if (kSunMaps == 0u) return 1.0;
    int first = shadowFirst[index];
    if (first < 0) return 1.0;
    vec3 toLight = light.type == kLightDirectional ? -light.direction : light.position - p.position;
    if (kSunMaps > 1u && light.type == kLightDirectional) return sunReaches(first, p, toLight);
    if (light.type == kLightPoint) first += int(shadowFace(-toLight));
    return mapReaches(shadowViews[first], p, toLight);
}

// The same by what the pass knows best: it defines this.
float lightReaches(uint index, Light light, ShadedPoint p);

// Every light as from its centre, or from the middle of its disc: its size blurs no highlight here.
vec3 directLight(Bsdf b, BsdfView view, Frame frame, ShadedPoint p)
{
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < kLights; ++i) {
        Light light = lights[i];
        light.radius = 0.0;
        light.sinAngle = 0.0;
        LightSample s = sampleLight(light, p.position, vec2(0.5));
        vec3 wi = toLocal(frame, s.direction);
        if (wi.z > 0.0 && s.radiance != vec3(0.0)) {
            float reaches = lightReaches(i, light, p);
            if (reaches > 0.0) {
                vec3 arriving = s.radiance * (wi.z * reaches);
                if (kMedia > 0u) arriving *= mediaTransmittance(Air(kMedia), p.position, s.direction, s.distance);
                sum += valueBsdf(b, view, wi).f * arriving;
            }
        }
    }
    return sum;
}

// Asked for where it counts alone: a read of a material that differs from pixel to pixel.
bool hasNormalMap(uint material) { return kDirectional && materials[material].normalTexture.texture >= 0; }

// Whether a lightmap lights a surface of that page: not where it has none, not on its back, and not while none is drawn.
bool hasLightmap(uint page) { return kLightmapPages > 0u && page < kGBufferBackPage; }

// Irradiance / pi that the bake left at the point.
vec3 bakedIrradiance(ShadedPoint p)
{
    if (hasLightmap(p.page)) {
        vec3 irradiance = lightmapValue(kLightmapPages, p.page, p.lightmapUv);
        if (p.bent) irradiance *= directionShare(lightmapDirection(kLightmapPages, p.page, p.lightmapUv), p.normal);
        return irradiance;
    }
    if (kProbes > 0u) return probeLookup(ProbeSet(kProbes), leaving(p.position, p.off, towardEye(p.normal, p.face, p.toEye)), p.normal);
    return lighting.ambient;
}

// What the interfaces mirror: the probes, or without them light of the point's own irradiance from everywhere.
vec3 mirroredLight(Bsdf b, float cosEye, ShadedPoint p, vec3 irradiance)
{
    if (p.mirrored != 0u || !hasInterface(b)) return vec3(0.0);
    vec3 radiance = irradiance;
    if (kReflections > 0u) {
        vec3 axis = lobeAxis(mirrorDirection(p.toEye, p.normal), p.normal, p.roughness);
        radiance = reflectedRadiance(kReflections, p.position, axis, p.roughness, irradiance);
    }
    return radiance * interfaceShare(b, cosEye, kReflections > 0u);
}

// What leaves a surface toward the eye, but for what it emits.
struct LeavingLight {
    vec3 direct;     // of the lights that the runtime draws
    vec3 indirect;   // of all other light, by the matte base, and by a metal's facets after several of them
    vec3 reflection; // of all other light, by the interfaces
};

LeavingLight leavingLight(Bsdf b, Frame frame, vec3 wo, ShadedPoint p)
{
    vec3 irradiance = bakedIrradiance(p);
    BsdfView view = viewBsdf(b, wo);
    LeavingLight light;
    light.direct = directLight(b, view, frame, p);
    vec3 albedo = eonAlbedo(b.diffuse, b.roughness, wo.z);
    vec3 again = kReflections > 0u ? view.again : vec3(0.0); // else the interfaces' share holds it
    light.indirect = irradiance * (albedo * view.pass + again);
    light.reflection = mirroredLight(b, wo.z, p, irradiance);
    if (kOcclusion) {
        light.indirect *= bouncedVisibility(p.open, albedo + again);
        light.reflection *= specularVisibility(p.open, wo.z, p.roughness);
    }
    return light;
}

vec3 sumOf(LeavingLight light) { return light.direct + (light.indirect + light.reflection); }

#endif
