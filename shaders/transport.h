// The one path estimator: radiance that arrives along a ray, by path tracing with next-event estimation, multiple importance sampling,
// Russian roulette, and free flight through homogeneous media. The baker (Embree) and the runtime (ray query) include this same text.
//
// The includer defines, before this line:
//   struct Tracer                                          what the functions below need, passed by value
//   Hit     closestHit(Tracer, Ray)                        alpha masks applied
//   Surface surfaceAt(Tracer, Ray, Hit)                    the shading point, textures read
//   vec3    transmittance(Tracer, Ray)                     fraction that passes up to ray.far: 0 behind opaque surfaces, tint of thin glass
//   uint    lightCount(Tracer);  Light lightAt(Tracer, uint)          punctual lights
//   LightSample sampleEmitter(Tracer, vec3 from, float, vec2)         a point on an emissive triangle; pdf 0: there is none
//   float   emitterPdf(Tracer, Ray, Hit, Surface)                     solid-angle pdf with which sampleEmitter finds that point
//   vec3    skyRadiance(Tracer, vec3 direction)
//   LightSample sampleSky(Tracer, vec2);  float skyPdf(Tracer, vec3)  pdf 0: the sky is left to BSDF sampling
//   uint    mediumCount(Tracer); Medium mediumAt(Tracer, uint)
//   PathSettings settings(Tracer)
// This work is based on: Veach 1997 (ch. 9 and 10); pbrt 4ed 13 and 14.
#ifndef AFTERGLOW_TRANSPORT_H
#define AFTERGLOW_TRANSPORT_H
#include "shaders/color.h"
#include "shaders/frame.h"
#include "shaders/light.h"
#include "shaders/medium.h"
#include "shaders/path.h"
#include "shaders/phase.h"
#include "shaders/random.h"
#include "shaders/ray.h"
#include "shaders/sampling.h"
#include "shaders/scene.h"
SHARED_BEGIN

const uint kDirectPunctual = 0u; // the categories of light that next-event estimation asks one after another
const uint kDirectEmitter = 1u;
const uint kDirectSky = 2u;
const uint kDirectCategories = 3u;

// Weight of a punctual light in the choice of one: its unoccluded irradiance, never 0 where it can contribute.
FN float punctualWeight(Light light, vec3 from)
{
    if (light.type == kLightDirectional) return luminance(light.intensity);
    vec3 offset = light.position - from;
    return luminance(light.intensity) / max(dot(offset, offset), max(light.radius * light.radius, kMinLightDistance * kMinLightDistance));
}

FN float punctualTotal(Tracer tracer, vec3 from)
{
    float total = 0.0f;
    for (uint i = 0u; i < lightCount(tracer); i++) total += punctualWeight(lightAt(tracer, i), from);
    return total;
}

// One punctual light, chosen in proportion to punctualWeight; its pdf includes the choice (a delta light's radiance is divided by it).
FN LightSample samplePunctual(Tracer tracer, vec3 from, float choice, vec2 u)
{
    LightSample picked = noLight();
    float total = punctualTotal(tracer, from);
    if (!(total > 0.0f)) return picked;
    float target = choice * total;
    uint last = lightCount(tracer) - 1u;
    for (uint i = 0u; i <= last; i++) {
        Light light = lightAt(tracer, i);
        float weight = punctualWeight(light, from);
        target -= weight;
        if ((target >= 0.0f && i < last) || !(weight > 0.0f)) continue;
        picked = sampleLight(light, from, u);
        float probability = weight / total;
        if (picked.delta != 0u)
            picked.radiance /= probability;
        else
            picked.pdf *= probability;
        break;
    }
    return picked;
}

// Punctual lights with a size, met between `near` and ray.far by a ray that was sampled with `pdf` at its origin: radiance, weighted
// against samplePunctual.
FN vec3 punctualAlong(Tracer tracer, Ray ray, float near, float pdf)
{
    vec3 sum = vec3(0.0f);
    if (lightCount(tracer) == 0u) return sum;
    float total = -1.0f;
    for (uint i = 0u; i < lightCount(tracer); i++) {
        Light light = lightAt(tracer, i);
        LightSample met = hitLight(light, ray.origin, ray.direction);
        if (!(met.pdf > 0.0f) || met.distance < near || (met.distance >= ray.far && ray.far < kRayFar)) continue;
        float weight = 1.0f;
        if (pdf > 0.0f) {
            if (total < 0.0f) total = punctualTotal(tracer, ray.origin);
            weight = powerHeuristic(pdf, met.pdf * punctualWeight(light, ray.origin) / total);
        }
        sum += met.radiance * weight;
    }
    return sum;
}

FN LightSample sampleDirect(Tracer tracer, uint category, vec3 from, float choice, vec2 u)
{
    if (category == kDirectPunctual) return samplePunctual(tracer, from, choice, u);
    if (category == kDirectEmitter) return sampleEmitter(tracer, from, choice, u);
    return sampleSky(tracer, u);
}

// Optical transmittance of the level's media along a segment.
FN vec3 mediaTransmittance(Tracer tracer, Ray ray)
{
    vec3 depth = vec3(0.0f);
    for (uint i = 0u; i < mediumCount(tracer); i++) {
        Medium medium = mediumAt(tracer, i);
        vec2 inside = mediumInterval(medium, ray.origin, ray.direction, ray.far);
        depth += (medium.scattering + medium.absorption) * max(inside.y - inside.x, 0.0f);
    }
    return exp(-depth);
}

// Fraction of a light sample, taken at `position`, that reaches `origin`: the same point, pushed off its surface. From there the ray is
// aimed anew at the sampled point (a shifted ray would meet a ceiling that its light lies in), and stops short of it.
FN vec3 visibility(Tracer tracer, vec3 position, vec3 origin, LightSample light)
{
    Ray shadow = Ray(origin, light.direction, kRayFar);
    if (light.distance < kRayFar) {
        vec3 toLight = position + light.direction * light.distance - origin;
        float distance_ = length(toLight);
        shadow.far = distance_ - max(distance_ * kShadowShortening, length(origin - position));
        if (!(shadow.far > 0.0f)) return vec3(1.0f);
        shadow.direction = toLight / distance_;
    }
    vec3 passed = transmittance(tracer, shadow);
    if (mediumCount(tracer) == 0u || passed == vec3(0.0f)) return passed;
    return passed * mediaTransmittance(tracer, shadow);
}

// Light that reaches a surface straight from lights, emitters and sky, and leaves towards `viewer`: one sample of each category.
FN vec3 directAtSurface(Tracer tracer, Surface surface, vec3 viewer, INOUT(Sampler) random)
{
    vec3 wo = toLocal(surface.frame, viewer);
    vec3 sum = vec3(0.0f);
    for (uint category = 0u; category < kDirectCategories; category++) {
        float choice = next1(random);
        LightSample light = sampleDirect(tracer, category, surface.position, choice, next2(random));
        if (!(light.pdf > 0.0f)) continue;
        vec3 wi = toLocal(surface.frame, light.direction);
        float side = dot(light.direction, surface.geometricNormal);
        if (side * wi.z <= 0.0f) continue; // a shading normal must not let light through a wall
        BsdfValue value = bsdfValue(surface.bsdf, wo, wi);
        vec3 contribution = value.f * abs(wi.z) * light.radiance;
        if (!(largestOf(contribution) > 0.0f)) continue;
        if (light.delta == 0u) contribution *= powerHeuristic(light.pdf, value.pdf) / light.pdf;
        vec3 origin = offsetRay(surface.position, side > 0.0f ? surface.geometricNormal : -surface.geometricNormal);
        sum += contribution * visibility(tracer, surface.position, origin, light);
    }
    return sum;
}

// The same at a point of a medium, by its phase function.
FN vec3 directInMedium(Tracer tracer, vec3 position, vec3 direction, float g, INOUT(Sampler) random)
{
    vec3 sum = vec3(0.0f);
    for (uint category = 0u; category < kDirectCategories; category++) {
        float choice = next1(random);
        LightSample light = sampleDirect(tracer, category, position, choice, next2(random));
        if (!(light.pdf > 0.0f)) continue;
        float phase = phaseHg(g, dot(direction, light.direction));
        vec3 contribution = phase * light.radiance;
        if (light.delta == 0u) contribution *= powerHeuristic(light.pdf, phase) / light.pdf;
        sum += contribution * visibility(tracer, position, position, light);
    }
    return sum;
}

// Free flight along `ray`: where the next collision with a medium lies (distance >= ray.far: none), the weight of the path that goes on,
// and the mean cosine there. Distances are drawn for the mean extinction of the three channels and weighted by each (chromatic media stay
// unbiased: pdf = average over channels).
struct Flight {
    float distance;
    vec3 weight;
    float g;
    uint scattered;
};
FN Flight flyThroughMedia(Tracer tracer, Ray ray, INOUT(Sampler) random)
{
    Flight flight = Flight(ray.far, vec3(1.0f), 0.0f, 0u);
    if (mediumCount(tracer) == 0u) return flight;
    float position = 0.0f;
    float channel = next1(random);
    float remaining = -log(1.0f - next1(random)); // optical depth until the collision, in the drawn channel
    vec3 depth = vec3(0.0f);
    while (position < ray.far) {
        // The media that cover the stretch up to the next border, and that border.
        float border = ray.far;
        vec3 scattering = vec3(0.0f);
        vec3 extinction = vec3(0.0f);
        float cosine = 0.0f;
        for (uint i = 0u; i < mediumCount(tracer); i++) {
            Medium medium = mediumAt(tracer, i);
            vec2 inside = mediumInterval(medium, ray.origin, ray.direction, ray.far);
            if (inside.x > position)
                border = min(border, inside.x);
            else if (inside.y > position) {
                border = min(border, inside.y);
                scattering += medium.scattering;
                extinction += medium.scattering + medium.absorption;
                cosine += medium.g * luminance(medium.scattering);
            }
        }
        float drawn = channel < 1.0f / 3.0f ? extinction.x : channel < 2.0f / 3.0f ? extinction.y : extinction.z;
        float step = border - position;
        if (drawn * step > remaining) {
            step = remaining / drawn;
            depth += extinction * step;
            vec3 passed = exp(-depth);
            float pdf = dot(extinction * passed, vec3(1.0f / 3.0f));
            flight.distance = position + step;
            flight.weight = pdf > 0.0f ? scattering * passed / pdf : vec3(0.0f);
            float total = luminance(scattering);
            flight.g = total > 0.0f ? cosine / total : 0.0f;
            flight.scattered = 1u;
            return flight;
        }
        remaining -= drawn * step;
        depth += extinction * step;
        position = border;
    }
    vec3 passed = exp(-depth);
    float pdf = dot(passed, vec3(1.0f / 3.0f));
    flight.weight = pdf > 0.0f ? passed / pdf : vec3(0.0f);
    return flight;
}

// What a ray met last, seen from where it was sampled with solid-angle pdf `pdf` (0: a camera or a mirror; nothing else could find it).
FN vec3 emissionAlong(Tracer tracer, Ray ray, Hit hit, Surface surface, float pdf)
{
    float weight = 1.0f;
    vec3 emission = surface.emission;
    if (!(pdf > 0.0f)) return emission + surface.unlit;
    if (largestOf(emission) > 0.0f) weight = powerHeuristic(pdf, emitterPdf(tracer, ray, hit, surface));
    return emission * weight;
}
FN vec3 skyAlong(Tracer tracer, vec3 direction, float pdf)
{
    float other = skyPdf(tracer, direction);
    return skyRadiance(tracer, direction) * (pdf > 0.0f ? powerHeuristic(pdf, other) : 1.0f);
}

// Radiance that arrives at ray.origin along `ray`, whose first hit the caller has found already (the baker finds them in packets).
// `pdf` is the solid-angle pdf with which the ray was sampled where next-event estimation was done too, 0 where it was not.
// Punctual lights are invisible to this first segment; later segments meet those that have a size.
FN vec3 radianceAlong(Tracer tracer, Ray ray, Hit hit, float pdf, INOUT(Sampler) random)
{
    PathSettings limits = settings(tracer);
    vec3 sum = vec3(0.0f);
    vec3 throughput = vec3(1.0f);
    vec3 anchor = ray.origin; // where `pdf` was sampled: thin glass passed straight through moves the ray's origin, not this
    float travelled = 0.0f;   // m from the anchor to ray.origin
    for (uint bounce = 0u;; bounce++) {
        // Fly through the media up to the hit
        ray.far = hit.distance;
        Flight flight = flyThroughMedia(tracer, ray, random);
        throughput *= flight.weight;
        if (bounce > 0u) {
            Ray whole = Ray(anchor, ray.direction, travelled + flight.distance);
            sum += throughput * punctualAlong(tracer, whole, travelled, pdf);
        }

        Surface surface;
        bool missed = flight.scattered == 0u && !(hit.distance < kRayFar);
        if (missed) return sum + throughput * skyAlong(tracer, ray.direction, pdf);
        if (flight.scattered == 0u) {
            surface = surfaceAt(tracer, ray, hit);
            Hit whole = hit;
            whole.distance += travelled;
            sum += throughput * emissionAlong(tracer, ray, whole, surface, pdf);
        }
        if (bounce > limits.maxBounces) return sum;

        // Light that reaches this vertex directly, then the direction in which the path goes on
        vec3 position = ray.origin + ray.direction * flight.distance;
        if (flight.scattered != 0u) {
            sum += throughput * directInMedium(tracer, position, ray.direction, flight.g, random);
            PhaseSample turned = samplePhaseHg(flight.g, next2(random));
            vec3 onward = toWorld(makeFrame(ray.direction), turned.direction);
            pdf = turned.pdf;
            ray = Ray(position, onward, kRayFar);
            anchor = position;
            travelled = 0.0f;
        } else {
            vec3 viewer = -ray.direction;
            sum += throughput * directAtSurface(tracer, surface, viewer, random);
            vec3 wo = toLocal(surface.frame, viewer);
            float lobe = next1(random);
            BsdfSample next = bsdfSample(surface.bsdf, wo, lobe, next2(random));
            if (!(largestOf(next.weight) > 0.0f)) return sum;
            vec3 onward = toWorld(surface.frame, next.direction);
            float side = dot(onward, surface.geometricNormal);
            if (side * next.direction.z <= 0.0f) return sum;
            throughput *= next.weight;
            // Thin glass passed straight through leaves the ray what it was: the lights were asked for at the vertex before.
            bool straight = surface.bsdf.thin > 0.0f && next.lobe == (kLobeTransmission | kLobeDelta);
            vec3 origin = offsetRay(surface.position, side > 0.0f ? surface.geometricNormal : -surface.geometricNormal);
            if (straight) {
                travelled += hit.distance;
            } else {
                pdf = (next.lobe & kLobeDelta) != 0u ? 0.0f : next.pdf;
                anchor = origin;
                travelled = 0.0f;
            }
            ray = Ray(origin, onward, kRayFar);
        }

        // Russian roulette: unbiased, weight 1 / q
        if (bounce >= limits.rouletteFrom) {
            float survival = min(largestOf(throughput), kRouletteCeiling);
            if (!(next1(random) < survival)) return sum;
            throughput /= survival;
        }
        hit = closestHit(tracer, ray);
    }
    return sum;
}

// Radiance along a camera ray.
FN vec3 radianceSeen(Tracer tracer, Ray ray, INOUT(Sampler) random)
{
    return radianceAlong(tracer, ray, closestHit(tracer, ray), 0.0f, random);
}

SHARED_END
#endif
