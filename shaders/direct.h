// Next-event estimation: light that reaches a point straight from punctual lights, emissive triangles and the sky, one sample of each.
// Needs of its includer the lights, emitters, sky and transmittance that shaders/transport.h lists.
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

// Fraction of a light sample, taken at `position`, that reaches `origin`: the same point, pushed off its surface.
FN vec3 visibility(Tracer tracer, vec3 position, vec3 origin, LightSample light)
{
    Ray shadow = rayToLight(position, origin, light);
    if (!(shadow.far > 0.0f)) return vec3(1.0f);
    vec3 passed = transmittance(tracer, shadow);
    if (mediumCount(airOf(tracer)) == 0u || passed == vec3(0.0f)) return passed;
    return passed * mediaTransmittance(tracer, shadow);
}

// Light that reaches a surface straight from lights, emitters and sky, and leaves towards the eye of `view`: one sample of each category.
FN vec3 directAtSurface(Tracer tracer, IN(Surface) surface, BsdfView view, INOUT(Sampler) random)
{
    vec3 sum = vec3(0.0f);
    for (uint category = 0u; category < kDirectCategories; category++) {
        if (!hasDirect(tracer, category)) continue;
        float choice = next1(random);
        LightSample light = sampleDirect(tracer, category, surface.position, choice, next2(random));
        if (!(light.pdf > 0.0f)) continue;
        vec3 wi = toLocal(surface.frame, light.direction);
        float side = dot(light.direction, surface.geometricNormal);
        if (side * wi.z <= 0.0f) continue; // a shading normal must not let light through a wall
        BsdfValue value = valueBsdf(surface.bsdf, view, wi);
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
        if (!hasDirect(tracer, category)) continue;
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

SHARED_END
#endif
