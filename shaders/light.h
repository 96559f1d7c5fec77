// Single lights: what each sends to a point, a sample of it with its density, the density of a ray that met it by chance, and the sky's
// map. One estimate of reflected radiance: sample.radiance * f * cos / sample.pdf, times visibility up to sample.distance.
#ifndef AFTERGLOW_LIGHT_H
#define AFTERGLOW_LIGHT_H
#include "shaders/frame.h"
#include "shaders/sampling.h"
#include "shaders/scene.h"
SHARED_BEGIN

// Nearer than this a point of radius 0 shines as from here: 1/r^2 stays finite, and no scene of any scale notices.
const float kMinLightDistance = 1e-8f; // m

struct LightSample {
    vec3 direction; // unit, from the point to the light
    float distance; // m, to the light's surface; kFloatMax for a directional light
    vec3 radiance;  // of a delta light: irradiance on a surface facing it, with pdf 1
    float pdf;      // solid angle; 0: no light from here
    uint delta;     // 1: no ray meets it by chance, its MIS weight is 1
};

FN LightSample noLight()
{
    LightSample s;
    s.direction = vec3(0.0f, 0.0f, 1.0f);
    s.distance = 0.0f;
    s.radiance = vec3(0.0f, 0.0f, 0.0f);
    s.pdf = 0.0f;
    s.delta = 1u;
    return s;
}

// KHR_lights_punctual: window that ends a light at its range, and the cone of a spot (squared linear ramp of the cosine).
FN float lightWindow(float distance_, float range)
{
    if (!(range > 0.0f && range <= kFloatMax)) return 1.0f;
    float x = distance_ / range;
    return clamp(1.0f - x * x * x * x, 0.0f, 1.0f);
}
FN float spotCone(Light light, float cosAngle)
{
    float x = clamp((cosAngle - light.cosOuter) / max(light.cosInner - light.cosOuter, 1e-4f), 0.0f, 1.0f);
    return x * x;
}
// Intensity toward a point, window included; `toLight` unit, from the point to the light's centre.
FN vec3 lightIntensity(Light light, vec3 toLight, float distance_)
{
    float cone = light.type == kLightSpot ? spotCone(light, -dot(toLight, light.direction)) : 1.0f;
    return light.intensity * (cone * lightWindow(distance_, light.range));
}

// A light with a size is a sphere of constant radiance I / (pi R^2), or a disc of the sky of radiance E / (pi sin^2).
FN LightSample sampleSphereLight(Light light, vec3 from, vec2 u)
{
    LightSample s;
    vec3 offset = light.position - from;
    float d2 = dot(offset, offset), d = sqrt(d2), r = light.radius;
    vec3 axis = d > 0.0f ? offset / d : vec3(0.0f, 1.0f, 0.0f);
    s.radiance = lightIntensity(light, axis, d) * (kInvPi / (r * r));
    s.delta = 0u;
    if (d <= r) { // Inside: light from everywhere
        s.direction = sampleUniformSphere(u);
        s.pdf = kInvFourPi;
        float along = dot(offset, s.direction);
        s.distance = along + sqrt(max(along * along + (r - d) * (r + d), 0.0f));
        return s;
    }
    float sine = r / d;
    vec3 local = sampleUniformCone(sine, u);
    s.direction = toWorld(makeFrame(axis), local);
    s.pdf = uniformConePdf(sine);
    // Near intersection: along - half chord; the chord from the sine of the sampled angle, not from a difference of squares
    float miss2 = d2 * (local.x * local.x + local.y * local.y);
    s.distance = d * local.z - sqrt(max(r * r - miss2, 0.0f));
    return s;
}

FN LightSample sampleSunDisc(Light light, vec2 u)
{
    LightSample s;
    s.direction = toWorld(makeFrame(-light.direction), sampleUniformCone(light.sinAngle, u));
    s.distance = kFloatMax;
    s.radiance = light.intensity * (kInvPi / (light.sinAngle * light.sinAngle));
    s.pdf = uniformConePdf(light.sinAngle);
    s.delta = 0u;
    return s;
}

FN bool isDeltaLight(Light light) { return light.type == kLightDirectional ? !(light.sinAngle > 0.0f) : !(light.radius > 0.0f); }

FN LightSample sampleLight(Light light, vec3 from, vec2 u)
{
    if (light.type == kLightDirectional) {
        if (light.sinAngle > 0.0f) return sampleSunDisc(light, u);
        LightSample sun = noLight();
        sun.direction = -light.direction;
        sun.distance = kFloatMax;
        sun.radiance = light.intensity;
        sun.pdf = 1.0f;
        return sun;
    }
    if (light.radius > 0.0f) return sampleSphereLight(light, from, u);
    LightSample s = noLight();
    vec3 offset = light.position - from;
    s.distance = length(offset);
    s.direction = s.distance > 0.0f ? offset / s.distance : vec3(0.0f, 1.0f, 0.0f);
    float d = max(s.distance, kMinLightDistance);
    s.radiance = lightIntensity(light, s.direction, s.distance) / (d * d);
    s.pdf = 1.0f;
    return s;
}

// The same light met by a ray from `from` along unit `direction`, by chance: where, how bright, and how likely sampleLight was to choose
// it. pdf 0: missed (delta lights always are).
FN LightSample hitLight(Light light, vec3 from, vec3 direction)
{
    LightSample s = noLight();
    if (isDeltaLight(light)) return s;
    s.direction = direction;
    if (light.type == kLightDirectional) {
        vec3 across = cross(direction, light.direction);
        if (dot(direction, light.direction) >= 0.0f || dot(across, across) > light.sinAngle * light.sinAngle) return s;
        s.distance = kFloatMax;
        s.radiance = light.intensity * (kInvPi / (light.sinAngle * light.sinAngle));
        s.pdf = uniformConePdf(light.sinAngle);
        s.delta = 0u;
        return s;
    }
    vec3 offset = light.position - from;
    float r = light.radius, d = length(offset);
    float along = dot(offset, direction);
    vec3 miss = offset - direction * along;
    float chord2 = r * r - dot(miss, miss);
    bool inside = d <= r;
    if (!inside && (along <= 0.0f || !(chord2 > 0.0f))) return s;
    float halfChord = sqrt(max(chord2, 0.0f));
    s.distance = inside ? along + halfChord : along - halfChord;
    s.radiance = lightIntensity(light, d > 0.0f ? offset / d : direction, d) * (kInvPi / (r * r));
    s.pdf = inside ? kInvFourPi : uniformConePdf(r / d);
    s.delta = 0u;
    return s;
}

// Equirectangular sky: unit direction <-> [0,1]^2, row 0 at +y. u = 1/2 looks along +x, 3/4 along +z, 0 and 1 along -x: the map of Blender
// and of most glTF viewers. rotation turns the sky about +y, counter-clockwise seen from above, in radians.
FN vec2 skyUv(vec3 direction, float rotation)
{
    float azimuth = atan(direction.z, direction.x) + rotation; // a turn of the sky by +r carries +x toward -z
    float polar = atan(sqrt(direction.x * direction.x + direction.z * direction.z), direction.y);
    return vec2(fract(azimuth * kInvTwoPi + 0.5f), polar * kInvPi);
}
FN vec3 skyDirection(vec2 uv, float rotation)
{
    float azimuth = (uv.x - 0.5f) * kTwoPi - rotation;
    float polar = uv.y * kPi;
    return vec3(sin(polar) * cos(azimuth), cos(polar), sin(polar) * sin(azimuth));
}
// Solid angle of a texel row's every texel: the exact band, so that pole rows count for what they are.
FN float skyTexelSolidAngle(int row, int width, int height)
{
    float a = kPi * float(row) / float(height), step_ = kPi / float(height);
    // cos(a) - cos(a + step) = 2 sin(a + step/2) sin(step/2)
    return (kTwoPi / float(width)) * 2.0f * sin(a + 0.5f * step_) * sin(0.5f * step_);
}

SHARED_END
#endif
