// Next-event estimation: light that reaches a point straight from punctual lights, emissive triangles and the sky, one sample of each.
// Needs of its includer the lights, emitters, sky and shadow rays that shaders/transport.h lists.
#ifndef AFTERGLOW_DIRECT_H
#define AFTERGLOW_DIRECT_H
#include "shaders/color.h"
#include "shaders/flight.h"
#include "shaders/light.h"
#include "shaders/light_ray.h"
#include "shaders/phase.h"
#include "shaders/random.h"
#include "shaders/ray.h"
#include "shaders/sampling.h"
#include "shaders/scene.h"
SHARED_BEGIN

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

// A sample of a light that was chosen with this probability: its pdf includes the choice (a delta light's radiance is divided by it).
FN LightSample sampleChosen(Light light, vec3 from, vec2 u, float probability)
{
    LightSample sample_ = sampleLight(light, from, u);
    if (sample_.delta != 0u)
        sample_.radiance /= probability;
    else
        sample_.pdf *= probability;
    return sample_;
}

// One punctual light, chosen in proportion to punctualWeight.
FN LightSample samplePunctual(Tracer tracer, vec3 from, float choice, vec2 u)
{
    float total = punctualTotal(tracer, from);
    if (!(total > 0.0f)) return noLight();
    float target = choice * total;
    uint last = lightCount(tracer) - 1u;
    for (uint i = 0u; i <= last; i++) {
        Light light = lightAt(tracer, i);
        float weight = punctualWeight(light, from);
        target -= weight;
        if ((target < 0.0f || i == last) && weight > 0.0f) return sampleChosen(light, from, u, weight / total);
    }
    return noLight();
}

// Punctual lights with a size, met between `near` and ray.far by a ray that was sampled with `pdf` at its origin: radiance, weighted
// against samplePunctual and dimmed by the media beyond `near`. pdf 0: no such sample was taken.
FN vec3 punctualAlong(Tracer tracer, Ray ray, float near, float pdf)
{
    vec3 sum = vec3(0.0f);
    float total = -1.0f;
    for (uint i = 0u; i < lightCount(tracer); i++) {
        Light light = lightAt(tracer, i);
        LightSample met = hitLight(light, ray.origin, ray.direction);
        if (!(met.pdf > 0.0f) || met.distance < near || (met.distance >= ray.far && ray.far < kRayFar)) continue;
        vec3 arriving = met.radiance;
        if (!(largestOf(arriving) > 0.0f)) continue; // off, or outside of its cone: where all are, no sample was taken
        if (pdf > 0.0f) {
            if (total < 0.0f) total = punctualTotal(tracer, ray.origin);
            arriving *= powerHeuristic(pdf, met.pdf * punctualWeight(light, ray.origin) / total);
        }
        if (mediumCount(airOf(tracer)) > 0u)
            arriving *= mediaTransmittance(tracer, Ray(ray.origin + ray.direction * near, ray.direction, met.distance - near));
        sum += arriving;
    }
    return sum;
}

FN LightSample sampleDirect(Tracer tracer, uint category, vec3 from, float choice, vec2 u)
{
    if (category == kDirectPunctual) return samplePunctual(tracer, from, choice, u);
    if (category == kDirectEmitter) return sampleEmitter(tracer, from, choice, u);
    return sampleSky(tracer, u);
}

// What of `carried`, light of a sample that was taken at `position`, arrives at `origin`: the same point, pushed off its surface. Media dim
// it before the level is asked: light that they swallow costs no ray.
FN vec3 arriving(Tracer tracer, vec3 position, vec3 origin, IN(LightSample) light, vec3 carried)
{
    Ray shadow = rayToLight(position, origin, light);
    if (!(shadow.far > 0.0f)) return carried;
    if (mediumCount(airOf(tracer)) > 0u) carried *= mediaTransmittance(tracer, shadow);
    return largestOf(carried) > 0.0f ? unshadowed(tracer, shadow, carried) : vec3(0.0f);
}

// One sample of a category's light as a surface meets it, from `wi` in its frame; false: there is none, or it comes through the surface.
FN bool sampleAtSurface(Tracer tracer, uint category, IN(Surface) surface, INOUT(Sampler) random, OUT(LightSample) light, OUT(vec3) wi)
{
    float choice = next1(random);
    light = sampleDirect(tracer, category, surface.position, choice, next2(random));
    wi = vec3(0.0f);
    if (!(light.pdf > 0.0f)) return false;
    wi = toLocal(surface.frame, light.direction);
    return dot(light.direction, surface.geometricNormal) * wi.z > 0.0f; // a shading normal must not let light through a wall
}

// What of that sample leaves towards the eye by a lobe of this value, times the throughput of the path that brings it there.
FN vec3 lightThroughSurface(Tracer tracer, vec3 throughput, IN(Surface) surface, BsdfValue value, IN(LightSample) light, vec3 wi)
{
    vec3 contribution = value.f * abs(wi.z) * light.radiance;
    if (!(largestOf(contribution) > 0.0f)) return vec3(0.0f);
    if (light.delta == 0u) contribution *= powerHeuristic(light.pdf, value.pdf) / light.pdf;
    bool outside = dot(light.direction, surface.geometricNormal) > 0.0f;
    vec3 origin = leaving(surface, outside ? surface.geometricNormal : -surface.geometricNormal);
    return arriving(tracer, surface.position, origin, light, throughput * contribution);
}

// Light that reaches a surface straight from lights, emitters and sky, and leaves towards the eye of `view`: one sample of each category.
FN vec3 directAtSurface(Tracer tracer, vec3 throughput, IN(Surface) surface, IN(BsdfView) view, INOUT(Sampler) random)
{
    vec3 sum = vec3(0.0f);
    for (uint category = 0u; category < kDirectCategories; category++) {
        LightSample light;
        vec3 wi;
        if (!hasDirect(tracer, category) || !sampleAtSurface(tracer, category, surface, random, light, wi)) continue;
        sum += lightThroughSurface(tracer, throughput, surface, valueBsdf(surface.bsdf, view, wi), light, wi);
    }
    return sum;
}

// The same at a point of a medium, by its phase function.
FN vec3 directInMedium(Tracer tracer, vec3 throughput, vec3 position, vec3 direction, float g, INOUT(Sampler) random)
{
    vec3 sum = vec3(0.0f);
    for (uint category = 0u; category < kDirectCategories; category++) {
        if (!hasDirect(tracer, category)) continue;
        float choice = next1(random);
        LightSample light = sampleDirect(tracer, category, position, choice, next2(random));
        if (!(light.pdf > 0.0f)) continue;
        float phase = phaseHg(g, dot(direction, light.direction));
        vec3 contribution = phase * light.radiance;
        if (light.delta == 0u) contribution *= powerHeuristic(light.pdf, phase) / light.pdf;
        sum += arriving(tracer, position, position, light, throughput * contribution);
    }
    return sum;
}

SHARED_END
#endif
