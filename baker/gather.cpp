#include "baker/gather.hpp"
#include "shaders/lightmap.h"

namespace afterglow
{
namespace
{
// What one texel's path found that its neighbours can use.
struct Find {
    bool sky = false;
    vec3 position{0.0f}; // of y, pushed off its surface
    vec3 normal{0.0f};   // on the side that was met; of the sky, from it to us
    Surface surface;
    Hit hit;
    vec3 matte{0.0f}; // radiance of the surface's base, by what its layer lets out
    bool any = false;
};

// y as one texel sees it.
struct Sight {
    vec3 direction; // to y
    float distance;
    float cosine;                                            // at y
    float pdf;                                               // of the texel's rays, by solid angle
    float density;                                           // the same by area at y; of the sky, by solid angle. 0: unseen
    vec3 passed;                                             // what media on the way leave
    float found() const { return density * meanOf(passed); } // density with which the texel's rays end at y, past those media
};
}

void Neighbours::bend(int i, vec3 direction, vec3 light)
{
    if (directional) turn[i] += double(luminance(light)) * dvec3(directionOf(direction, white[i].frame.normal));
}

void Neighbours::gain(int i, vec3 direction, vec3 light)
{
    irradiance[i] += light;
    bend(i, direction, light);
}

// Light that reaches texel i straight from the lights.
static void gainDirect(Tracer here, Neighbours& group, int i)
{
    const Surface& white = group.white[i];
    Arrivals arrivals;
    if (group.directional) here.arrivals = &arrivals;
    group.irradiance[i] += directAtSurface(here, vec3(1.0f), white, viewBsdf(white.bsdf, vec3(0.0f, 0.0f, 1.0f)), group.random[i]);
    for (uint k = 0; k < arrivals.count; k++) group.bend(i, arrivals.of[k].direction, arrivals.of[k].value);
}

// Light of a path that collided with a medium before it met anything.
static vec3 turned(Tracer here, Tracer beyond, const Ray& ray, const Flight& flight, float pdf, Sampler& random)
{
    Path path = beginPath(ray, pdf, random);
    path.throughput = flight.weight;
    if (settings(beyond).maxCollisions > 0u && turnInMedium(beyond, flight, path)) follow(here, beyond, unknownHit(), path);
    random = path.random;
    return path.radiance;
}

// Follows texel j's path. Returns the light that is its own, and fills `find` with what its neighbours can use too.
static vec3 explore(Tracer here, Tracer beyond, Neighbours& group, int j, Find& find)
{
    const Ray& ray = group.rays[j];
    const Hit& hit = group.hits[j];
    Sampler& random = group.random[j];
    const Surface& white = group.white[j];
    const float cosine = dot(ray.direction, white.frame.normal);
    // Directions behind the geometric surface see only the surface itself
    if (!(cosine > 0.0f) || !(dot(ray.direction, white.geometricNormal) > 0.0f)) return vec3(0.0f);
    const float pdf = cosine * kInvPi;
    const bool met = hit.distance < kRayFar;
    if (met) find.surface = surfaceAt(beyond, ray, hit);
    const Surface& surface = find.surface;
    if (met && (surface.bsdf.roughness > 0.0f || surface.absorption != vec3(0.0f)))
        return radianceAlong(here, beyond, ray, hit, pdf, random);

    // Up to y: lights on the way, and media, in which the path may turn before
    const Ray whole{ray.origin, ray.direction, hit.distance};
    vec3 own = punctualAlong(here, whole, 0.0f, pdf);
    if (mediumCount(airOf(beyond)) > 0) {
        own += mediaEmission(beyond, whole);
        const Flight flight = flyThroughMedia(beyond, whole, vec3(1.0f), random);
        if (flight.scattered != 0u) return own + turned(here, beyond, whole, flight, pdf, random);
    }
    find.hit = hit;
    if (!met) {
        find.any = find.sky = true;
        find.normal = -ray.direction;
        return own;
    }

    // Light that leaves y by its base, whose law is the same for all who see it but for one factor, and by its other lobes
    const BsdfView view = viewBsdf(surface.bsdf, toLocal(surface.frame, -ray.direction));
    vec3 matte(0.0f);
    for (uint category = 0; category < kDirectCategories; category++) {
        LightSample light;
        vec3 wi;
        if (!hasDirect(beyond, category) || !sampleAtSurface(beyond, category, surface, random, light, wi)) continue;
        const BsdfValue value = valueBsdf(surface.bsdf, view, wi);
        const vec3 left = lightThroughSurface(beyond, vec3(1.0f), surface, value, light, wi),
                   share = baseShare(surface.bsdf, view, wi, value.f);
        matte += share * left;
        own += (1.0f - share) * left;
    }
    Path path = beginPath(ray, pdf, random);
    if (turnAtSurface(settings(beyond), surface, view, hit.distance, path)) {
        const vec3 wi = toLocal(surface.frame, path.ray.direction);
        const bool delta = path.pdf == 0.0f;
        follow(here, beyond, unknownHit(), path);
        const vec3 share = delta ? vec3(0.0f) : baseShare(surface.bsdf, view, wi, valueBsdf(surface.bsdf, view, wi).f);
        matte += share * path.radiance;
        own += (1.0f - share) * path.radiance;
    }
    random = path.random;
    find.normal = dot(surface.geometricNormal, ray.direction) < 0.0f ? surface.geometricNormal : -surface.geometricNormal;
    find.position = leaving(surface, find.normal);
    if (view.pass > 0.0f) find.matte = matte / view.pass;
    find.any = largestOf(find.matte) > 0.0f || largestOf(surface.emission) > 0.0f;
    return own;
}

// How texel i sees y, if nothing is in the way.
static Sight sightOf(Tracer beyond, const Neighbours& group, int i, const Find& find)
{
    Sight sight{-find.normal, kRayFar, 1.0f, 0.0f, 0.0f, vec3(1.0f)};
    float perArea = 1.0f;
    if (!find.sky) {
        const vec3 offset = find.position - group.rays[i].origin;
        const float squared = dot(offset, offset);
        if (!(squared > 0.0f)) return sight;
        sight.distance = std::sqrt(squared);
        sight.direction = offset / sight.distance;
        sight.cosine = -dot(sight.direction, find.normal);
        perArea = sight.cosine / squared;
    }
    const Surface& white = group.white[i];
    const float cosine = dot(sight.direction, white.frame.normal);
    if (!(cosine > 0.0f && sight.cosine > 0.0f && dot(sight.direction, white.geometricNormal) > 0.0f)) return sight;
    sight.pdf = cosine * kInvPi;
    sight.density = sight.pdf * perArea;
    if (mediumCount(airOf(beyond)) > 0)
        sight.passed = mediaTransmittance(beyond, Ray{group.rays[i].origin, sight.direction, sight.distance});
    return sight;
}

// Radiance of y towards a texel, weighted against the light samples that the texel itself took.
static vec3 radianceOf(Tracer beyond, const Neighbours& group, int i, const Find& find, const Sight& sight)
{
    if (find.sky) return skyAlong(beyond, sight.direction, sight.pdf);
    const Hit hit{sight.distance, find.hit.triangle, find.hit.barycentric};
    return emissionAlong(beyond, Ray{group.rays[i].origin, sight.direction, kRayFar}, hit, find.surface, sight.pdf) +
           find.matte * basePass(find.surface.bsdf, sight.cosine);
}

// Gives what texel j's path found to all who see it.
static void share(Tracer beyond, Neighbours& group, int j, const Find& find)
{
    Sight sights[kPacket];
    Ray rays[kPacket];
    int asked[kPacket], count = 0;
    for (int i = 0; i < group.count; i++) {
        sights[i] = sightOf(beyond, group, i, find);
        if (i == j || !(sights[i].density > 0.0f)) continue;
        rays[count] = {group.rays[i].origin, sights[i].direction, find.sky ? kRayFar : sights[i].distance * (1.0f - kShadowShortening)};
        asked[count++] = i;
    }
    bool free[kPacket];
    if (count > 0) beyond.transport->world.unoccluded(rays, free, count);
    beyond.rays->shadowPacked += std::uint64_t(count);
    for (int k = 0; k < count; k++)
        if (!free[k]) sights[asked[k]].density = 0.0f;

    float total = 0.0f;
    for (int i = 0; i < group.count; i++) total += sights[i].found();
    if (!(total > 0.0f)) return; // rounding alone: j's own ray ended there
    for (int i = 0; i < group.count; i++)
        if (sights[i].density > 0.0f)
            group.gain(i, sights[i].direction,
                       sights[i].density / total * sights[i].passed * radianceOf(beyond, group, i, find, sights[i]));
}

void gather(Tracer here, Tracer beyond, Neighbours& group)
{
    here.transport->world.closestHits(group.rays, group.hits, group.count, /* coherent= */ false);
    here.rays->closestPacked += std::uint64_t(group.count);
    Find finds[kPacket];
    for (int j = 0; j < group.count; j++) {
        group.begin(j);
        gainDirect(here, group, j);
        group.gain(j, group.rays[j].direction, explore(here, beyond, group, j, finds[j]));
    }
    for (int j = 0; j < group.count; j++)
        if (finds[j].any) share(beyond, group, j, finds[j]);
}
}
