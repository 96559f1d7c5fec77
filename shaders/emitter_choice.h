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

FN uint chooseEmitter(EmitterSet all, float u)
{
    uint count = emitterCount(all);
    uint i = emitterAt(all, min(uint(u * float(count)), count - 1u)).guide;
    while (i > 0u && emitterAt(all, i - 1u).upTo > u) i--; // a product rounded up
    while (i + 1u < count && !(emitterAt(all, i).upTo > u)) i++;
    return i;
}

// A point on an emitter, uniform over its area; pdf in solid angle about `from`, 0 when nothing emits toward it.
FN LightSample sampleEmitters(EmitterSet all, vec3 from, float choice, vec2 u)
{
    LightSample light = noLight();
    if (emitterCount(all) == 0u) return light;
    Emitter emitter = emitterAt(all, chooseEmitter(all, choice));
    vec3 b = sampleTriangle(u);
    vec3 offset = emitter.corner + b.y * emitter.edge1 + b.z * emitter.edge2 - from;
    float squared = dot(offset, offset);
    if (!(squared > 0.0f)) return light;
    light.distance = sqrt(squared);
    light.direction = offset / light.distance;
    float cosine = -dot(emitter.normal, light.direction);
    if ((emitter.flags & kEmitterBothSides) != 0u) cosine = abs(cosine);
    if (!(cosine > 0.0f)) return light;
    light.delta = 0u;
    light.radiance = emitter.emission;
    if ((emitter.flags & kEmitterVaries) != 0u) light.radiance = emissionAt(all, emitter.triangle, vec2(b.y, b.z));
    light.pdf = emitter.density * squared / cosine;
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
