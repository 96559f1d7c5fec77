// Sampling of the emissive triangles of a level, in proportion to their power, and the density of that.
// The includer defines, before this line:
//   struct EmitterSet                                            what the functions below need, passed by value
//   uint    emitterCount(EmitterSet);  Emitter emitterAt(EmitterSet, uint)      the table, in its order
//   float   emitterDensity(EmitterSet, uint triangle)            Emitter::density of a triangle of the tracer; 0: it does not emit
//   vec3    emissionAt(EmitterSet, uint triangle, vec2 barycentric)             of one that varies: metEmission of shaders/met.h
#ifndef AFTERGLOW_EMITTER_CHOICE_H
#define AFTERGLOW_EMITTER_CHOICE_H
#include "shaders/emitter.h"
#include "shaders/light.h"
#include "shaders/ray.h"
#include "shaders/sampling.h"
SHARED_BEGIN

// A product that is rounded up may take the next one: by 2^-24 of each.
FN uint chooseEmitter(EmitterSet all, float u)
{
    uint count = emitterCount(all);
    uint i = emitterAt(all, min(uint(u * float(count)), count - 1u)).guide;
    while (!(emitterAt(all, i).upTo > u) && i + 1u < count) i++;
    return i;
}

const float kLeastDistance = 1e-30f; // m: a point of the emitter itself has no direction to it, but no NaN either

// A point on an emitter by its weights, as light at `from`: its factor of radiance; pdf in solid angle about `from`, 0 when nothing comes there.
FN LightSample emitterLight(IN(Emitter) emitter, vec3 b, vec3 from)
{
    LightSample light;
    vec3 offset = emitter.corner + b.y * emitter.edge1 + b.z * emitter.edge2 - from;
    float squared = dot(offset, offset);
    light.distance = sqrt(squared);
    light.direction = offset / max(light.distance, kLeastDistance);
    float facing = -dot(emitter.normal, light.direction);
    float cosine = (emitter.flags & kEmitterBothSides) != 0u ? abs(facing) : facing;
    light.radiance = emitter.emission;
    light.pdf = squared > 0.0f && cosine > 0.0f ? emitter.density * squared / cosine : 0.0f;
    light.delta = 0u;
    return light;
}

// Of an emitter chosen by `choice`, a point uniform over its area.
FN LightSample sampleEmitters(EmitterSet all, vec3 from, float choice, vec2 u)
{
    if (emitterCount(all) == 0u) return noLight();
    Emitter emitter = emitterAt(all, chooseEmitter(all, choice));
    vec3 b = sampleTriangle(u);
    LightSample light = emitterLight(emitter, b, from);
    if (light.pdf > 0.0f && (emitter.flags & kEmitterVaries) != 0u) light.radiance = emissionAt(all, emitter.triangle, vec2(b.y, b.z));
    return light;
}

// The pdf with which sampleEmitters finds what a ray met.
FN float emittersPdf(EmitterSet all, IN(Ray) ray, IN(Hit) hit, IN(Surface) surface)
{
    if (emitterCount(all) == 0u) return 0.0f;
    float cosine = abs(dot(ray.direction, surface.geometricNormal));
    return cosine > 0.0f ? emitterDensity(all, hit.triangle) * hit.distance * hit.distance / cosine : 0.0f;
}

SHARED_END
#endif
