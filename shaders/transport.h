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
//   bool    hasDirect(Tracer, uint category)               false: the category (kDirect... of shaders/path.h) has no light to sample
//   vec3    skyRadiance(Tracer, vec3 direction)
//   LightSample sampleSky(Tracer, vec2);  float skyPdf(Tracer, vec3)  pdf 0: the sky is left to BSDF sampling
//   Air     airOf(Tracer)                                  the media: what shaders/media.h asks for
//   PathSettings settings(Tracer)
// This work is based on: Veach 1997 (ch. 9 and 10); pbrt 4ed 13 and 14.
#ifndef AFTERGLOW_TRANSPORT_H
#define AFTERGLOW_TRANSPORT_H
#include "shaders/direct.h"
#include "shaders/flight.h"
#include "shaders/frame.h"
#include "shaders/light.h"
#include "shaders/medium.h"
#include "shaders/path.h"
#include "shaders/phase.h"
#include "shaders/random.h"
#include "shaders/ray.h"
#include "shaders/sampling.h"
SHARED_BEGIN

// What a ray met last, seen from where it was sampled with solid-angle pdf `pdf` (0: a camera or a mirror; nothing else could find it).
FN vec3 emissionAlong(Tracer tracer, Ray ray, Hit hit, IN(Surface) surface, float pdf)
{
    vec3 emission = surface.emission;
    if (pdf > 0.0f && largestOf(emission) > 0.0f) emission *= powerHeuristic(pdf, emitterPdf(tracer, ray, hit, surface));
    return emission;
}
FN vec3 skyAlong(Tracer tracer, vec3 direction, float pdf)
{
    float other = skyPdf(tracer, direction);
    return skyRadiance(tracer, direction) * (pdf > 0.0f ? powerHeuristic(pdf, other) : 1.0f);
}

// A path may end by chance: false ends it, true has weighted it by 1 / (chance to live). Unbiased.
FN bool goesOn(INOUT(vec3) throughput, float ceiling, INOUT(Sampler) random)
{
    float survival = min(largestOf(throughput), ceiling);
    if (!(next1(random) < survival)) return false;
    throughput /= survival;
    return true;
}

// A hit that is still to be asked for.
FN Hit unknownHit() { return Hit(-1.0f, 0u, vec2(0.0f)); }

// Radiance that arrives at ray.origin along `ray`, whose first hit the caller may have found already (the baker finds them in packets).
// `pdf` is the solid-angle pdf with which the ray was sampled where next-event estimation was done too; 0: a camera's ray, which alone
// sees what is unlit, straight or through mirrors and clear glass.
// `first` holds the punctual lights that the ray may meet before it is turned: those that next-event estimation asked for at its origin,
// and none for a camera. Beyond, paths meet those of `tracer`.
FN vec3 radianceAlong(Tracer first, Tracer tracer, Ray ray, Hit hit, float pdf, INOUT(Sampler) random)
{
    PathSettings limits = settings(tracer);
    vec3 sum = vec3(0.0f);
    vec3 throughput = vec3(1.0f);
    vec3 anchor = ray.origin; // where `pdf` was sampled: thin glass passed straight through moves the ray's origin, not this
    float travelled = 0.0f;   // m from the anchor to ray.origin
    bool turned = false;      // somewhere before
    bool seen = pdf == 0.0f;  // by a camera, as in a mirror
    uint surfaces = 0u;       // that the path met
    uint collisions = 0u;     // with media
    while (true) {
        if (hit.distance < 0.0f) hit = closestHit(tracer, ray); // here alone: a shader holds all that is called, each time it is called

        // Lights on the way, then the flight through the media up to the hit
        Ray whole = Ray(anchor, ray.direction, travelled + hit.distance);
        Tracer asked = first;
        if (turned) asked = tracer;
        sum += throughput * punctualAlong(asked, whole, travelled, pdf);
        ray.far = hit.distance;
        if (limits.glow != 0u) sum += throughput * mediaEmission(tracer, ray);
        Flight flight = flyThroughMedia(tracer, ray, throughput, random);
        throughput *= flight.weight;

        Surface surface;
        bool collided = flight.scattered != 0u;
        if (!collided) {
            if (!(hit.distance < kRayFar)) return sum + throughput * skyAlong(tracer, ray.direction, pdf);
            surface = surfaceAt(tracer, ray, hit);
            throughput *= transmittance(surface.absorption, hit.distance);
            Hit fromAnchor = hit;
            fromAnchor.distance += travelled;
            sum += throughput * emissionAlong(tracer, ray, fromAnchor, surface, pdf);
            if (seen) sum += throughput * surface.unlit;
        }
        if (surfaces > limits.maxBounces || surfaces + collisions > limits.maxVertices) return sum;
        if (collided && collisions >= limits.maxCollisions) return sum;

        // Light that reaches this vertex directly, then the direction in which the path goes on; it may end by chance
        if (collided) {
            vec3 position = ray.origin + ray.direction * flight.distance;
            sum += throughput * directInMedium(tracer, position, ray.direction, flight.g, random);
            PhaseSample scattered = samplePhaseHg(flight.g, next2(random));
            vec3 onward = toWorld(makeFrame(ray.direction), scattered.direction);
            pdf = scattered.pdf;
            ray = Ray(position, onward, kRayFar);
            anchor = position;
            travelled = 0.0f;
            turned = true;
            seen = false;
            collisions++;
            if (!goesOn(throughput, collisions < kFreeCollisions ? 1.0f : kCollisionCeiling, random)) return sum;
        } else {
            BsdfView view = viewBsdf(surface.bsdf, toLocal(surface.frame, -ray.direction));
            sum += throughput * directAtSurface(tracer, surface, view, random);
            float lobe = next1(random);
            BsdfSample next = sampleBsdf(surface.bsdf, view, lobe, next2(random));
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
                turned = true;
            }
            seen = seen && (next.lobe & kLobeDelta) != 0u;
            ray = Ray(origin, onward, kRayFar);
            if (surfaces >= limits.rouletteFrom && !goesOn(throughput, kRouletteCeiling, random)) return sum;
            surfaces++;
        }
        hit = unknownHit();
    }
    return sum;
}

// Radiance along a camera ray. `camera` is the tracer without punctual lights: a camera does not see them.
FN vec3 radianceSeen(Tracer camera, Tracer tracer, Ray ray, INOUT(Sampler) random)
{
    return radianceAlong(camera, tracer, ray, unknownHit(), 0.0f, random);
}

SHARED_END
#endif
