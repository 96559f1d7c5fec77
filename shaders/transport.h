// The one path estimator: radiance that arrives along a ray, by path tracing with next-event estimation, multiple importance sampling,
// Russian roulette, and free flight through homogeneous media. The baker (Embree) and the runtime (ray query) include this same text.
//
// The includer defines, before this line:
//   struct Tracer                                          what the functions below need, passed by value
//   Hit     closestHit(Tracer, Ray)                        alpha masks applied
//   Surface surfaceAt(Tracer, Ray, Hit)                    the shading point, textures read
//   vec3    unshadowed(Tracer, Ray, vec3 carried)          what of the light passes up to ray.far: none behind opaque surfaces, tinted by
//                                                          thin glass. Or 0, where the tracer adds it to the path's radiance later
//   uint    lightCount(Tracer);  Light lightAt(Tracer, uint)          punctual lights
//   LightSample sampleEmitter(Tracer, vec3 from, float, vec2)         a point on an emissive triangle; pdf 0: there is none
//   float   emitterPdf(Tracer, Ray, Hit, Surface)                     solid-angle pdf with which sampleEmitter finds that point
//   bool    hasDirect(Tracer, uint category)               false: the category (kDirect... of shaders/path.h) has no light to sample
//   vec3    skyRadiance(Tracer, vec3 direction)
//   LightSample sampleSky(Tracer, vec2);  float skyPdf(Tracer, vec3)  pdf 0: the sky is left to BSDF sampling
//   Air     airOf(Tracer)                                  the media: what shaders/media.h asks for
//   PathSettings settings(Tracer)
//   bool    knownBase(Tracer, Hit, IN(Surface), OUT(vec3))  what falls on the surface's base, by what its layer lets in, times its gain: an
//                                                          earlier pass has found it. false: the path has to
//   void    cutShort(Tracer)                               told of each path that maxBounces ends at a surface where it could go on
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

// A path between two of its vertices: the ray along which it goes on, and what it has gathered.
struct Path {
    Ray ray;
    vec3 throughput;
    vec3 radiance;   // so far, towards the eye
    vec3 anchor;     // where `pdf` was sampled: thin glass passed straight through moves the ray's origin, not this
    float travelled; // m from the anchor to ray.origin
    float pdf;       // solid angle, with which the direction was sampled; 0: by a camera or a mirror, nothing else could find it
    uint surfaces;   // that it has met
    uint collisions; // with media
    uint turned;     // 1: somewhere before
    uint seen;       // 1: by a camera, straight or as in a mirror
    Sampler random;
};
FN Path beginPath(Ray ray, float pdf, Sampler random)
{
    return Path(ray, vec3(1.0f), vec3(0.0f), ray.origin, 0.0f, pdf, 0u, 0u, 0u, pdf == 0.0f ? 1u : 0u, random);
}

// A path that collided with a medium turns there. false: it ends.
FN bool turnInMedium(Tracer tracer, Flight flight, INOUT(Path) path)
{
    vec3 position = path.ray.origin + path.ray.direction * flight.distance;
    path.radiance += directInMedium(tracer, path.throughput, position, path.ray.direction, flight.g, path.random);
    PhaseSample scattered = samplePhaseHg(flight.g, next2(path.random));
    path.ray = Ray(position, toWorld(makeFrame(path.ray.direction), scattered.direction), kRayFar);
    path.pdf = scattered.pdf;
    path.anchor = position;
    path.travelled = 0.0f;
    path.turned = 1u;
    path.seen = 0u;
    path.collisions++;
    return goesOn(path.throughput, path.collisions < kFreeCollisions ? 1.0f : kCollisionCeiling, path.random);
}

// A path that met a surface at `distance` turns there. false: it ends.
FN bool turnAtSurface(PathSettings limits, IN(Surface) surface, IN(BsdfView) view, float distance_, INOUT(Path) path)
{
    float lobe = next1(path.random);
    BsdfSample next = sampleBsdf(surface.bsdf, view, lobe, next2(path.random));
    if (!(largestOf(next.weight) > 0.0f)) return false;
    vec3 onward = toWorld(surface.frame, next.direction);
    float side = dot(onward, surface.geometricNormal);
    if (side * next.direction.z <= 0.0f) return false;
    path.throughput *= next.weight;
    vec3 origin = leaving(surface, side > 0.0f ? surface.geometricNormal : -surface.geometricNormal);
    bool delta = (next.lobe & kLobeDelta) != 0u;
    // Thin glass passed straight through leaves the ray what it was: the lights were asked for at the vertex before.
    if (surface.bsdf.thin > 0.0f && next.lobe == (kLobeTransmission | kLobeDelta)) {
        path.travelled += distance_;
    } else {
        path.pdf = delta ? 0.0f : next.pdf;
        path.anchor = origin;
        path.travelled = 0.0f;
        path.turned = 1u;
    }
    if (!delta) path.seen = 0u;
    path.ray = Ray(origin, onward, kRayFar);
    if (path.surfaces >= limits.rouletteFrom && !goesOn(path.throughput, kRouletteCeiling, path.random)) return false;
    path.surfaces++;
    return true;
}

// How many times as often as they would be chosen a path goes on with the lobes beside a base whose light is known: all that is left to
// find is theirs, and paths that end there cost nothing more. Experiment: 2, 4 and 8 are equal within 5 % of the error.
const float kOnward = 2.0f;

// Goes on with the lobes beside a surface's base, whose light is known. false: the path ends.
FN bool leaveBase(INOUT(Surface) surface, INOUT(BsdfView) view, INOUT(vec3) throughput, INOUT(Sampler) random)
{
    float chance = min(kOnward * (view.lobes.y + view.lobes.z), 1.0f);
    if (!(next1(random) < chance)) return false;
    throughput /= chance;
    surface.bsdf.diffuse = vec3(0.0f, 0.0f, 0.0f);
    view = viewBsdf(surface.bsdf, view.wo);
    return true;
}

// One step of a path, to the first thing that its ray meets: `hit`, or a medium before it. false: the path ends, its radiance is whole.
// `first` holds the punctual lights that the ray may meet before it is turned: those that next-event estimation asked for at its origin,
// and none for a camera. Beyond, paths meet those of `tracer`.
FN bool advance(Tracer first, Tracer tracer, Hit hit, INOUT(Path) path)
{
    PathSettings limits = settings(tracer);

    // Lights on the way, then the flight through the media up to the hit
    Ray whole = Ray(path.anchor, path.ray.direction, path.travelled + hit.distance);
    Tracer asked = first;
    if (path.turned != 0u) asked = tracer;
    path.radiance += path.throughput * punctualAlong(asked, whole, path.travelled, path.pdf);
    path.ray.far = hit.distance;
    if (limits.glow != 0u) path.radiance += path.throughput * mediaEmission(tracer, path.ray);
    Flight flight = flyThroughMedia(tracer, path.ray, path.throughput, path.random);
    path.throughput *= flight.weight;

    Surface surface;
    bool collided = flight.scattered != 0u;
    if (!collided) {
        if (!(hit.distance < kRayFar)) {
            path.radiance += path.throughput * skyAlong(tracer, path.ray.direction, path.pdf);
            return false;
        }
        surface = surfaceAt(tracer, path.ray, hit);
        path.throughput *= transmittance(surface.absorption, hit.distance);
        Hit fromAnchor = hit;
        fromAnchor.distance += path.travelled;
        path.radiance += path.throughput * emissionAlong(tracer, path.ray, fromAnchor, surface, path.pdf);
        if (path.seen != 0u) path.radiance += path.throughput * surface.unlit;
    }
    if (path.surfaces + path.collisions > limits.maxVertices) return false;
    if (collided && (path.surfaces > limits.maxBounces || path.collisions >= limits.maxCollisions)) return false;

    // Light that reaches this vertex directly, then the direction in which the path goes on; it may end by chance
    if (collided) return turnInMedium(tracer, flight, path);
    BsdfView view = viewBsdf(surface.bsdf, toLocal(surface.frame, -path.ray.direction));
    if (path.surfaces > limits.maxBounces) {
        if (largestOf(view.lobes) > 0.0f) cutShort(tracer);
        return false;
    }
    vec3 base;
    if (knownBase(tracer, hit, surface, base)) {
        path.radiance += path.throughput * surface.bsdf.diffuse * view.pass * base;
        if (!leaveBase(surface, view, path.throughput, path.random)) return false;
    }
    path.radiance += directAtSurface(tracer, path.throughput, surface, view, path.random);
    return turnAtSurface(limits, surface, view, hit.distance, path);
}

// A hit that is still to be asked for.
FN Hit unknownHit() { return Hit(-1.0f, 0u, vec2(0.0f)); }

// Follows a path to its end; then its radiance is whole. The caller may have found the first hit of its ray already (the baker finds them
// in packets).
FN void follow(Tracer first, Tracer tracer, Hit hit, INOUT(Path) path)
{
    do {
        if (hit.distance < 0.0f)
            hit = closestHit(tracer, path.ray); // here alone: a shader holds all that is called, each time it is called
        if (!advance(first, tracer, hit, path)) break;
        hit = unknownHit();
    } while (true);
}

// Radiance that arrives at ray.origin along `ray`. `pdf` is the solid-angle pdf with which the ray was sampled where next-event estimation
// was done too; 0: a camera's ray, which alone sees what is unlit, straight or through mirrors and clear glass. `first`: see advance().
FN vec3 radianceAlong(Tracer first, Tracer tracer, Ray ray, Hit hit, float pdf, INOUT(Sampler) random)
{
    Path path = beginPath(ray, pdf, random);
    follow(first, tracer, hit, path);
    random = path.random;
    return path.radiance;
}

// Radiance along a camera ray. `camera` is the tracer without punctual lights: a camera does not see them.
FN vec3 radianceSeen(Tracer camera, Tracer tracer, Ray ray, INOUT(Sampler) random)
{
    return radianceAlong(camera, tracer, ray, unknownHit(), 0.0f, random);
}

SHARED_END
#endif
