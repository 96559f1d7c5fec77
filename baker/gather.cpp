#include "baker/gather.hpp"
#include "baker/gather_direct.hpp"
#include "baker/sharing.hpp"
#include "shaders/lightmap.h"
#include <cmath>

namespace afterglow
{
void WhiteLanes::set(int i, vec3 at, vec3 from, vec3 shading, vec3 geometric)
{
    position.set(i, at), origin.set(i, from), normal.set(i, shading), geometricNormal.set(i, geometric);
}

void Neighbours::begin()
{
    for (int i = 0; i < kPacket; i++) irradiance.set(i, vec3(0.0f)), turn.set(i, vec3(0.0f)), more.set(i, vec3(0.0f));
    for (int i = count; i < kPacket; i++) white.set(i, vec3(0.0f), vec3(0.0f), vec3(0.0f), vec3(0.0f));
}

void Neighbours::gain(int i, vec3 direction, vec3 light)
{
    irradiance.add(i, light);
    if (directional) turn.add(i, luminance(light) * directionOf(direction, white.normal[i]));
}

void Neighbours::gain(const Lanes3& direction, const Lanes3& light)
{
    for (int i = 0; i < kPacket; i++) irradiance.add(i, light[i]);
    if (directional) bend(direction, light);
}

namespace
{
// directionOf() by a table, for it takes arcs: by the cosine alone it is `along` times the normal and `across` times what of the direction
// lies across that. Off by 1e-4 at most.
class Leans
{
public:
    Leans()
    {
        for (int i = 0; i <= kSteps; i++) {
            const float cosine = max(float(i) / float(kSteps), 1e-6f), sine = std::sqrt(max(1.0f - cosine * cosine, 1e-12f));
            const vec3 d = directionOf(vec3(sine, 0.0f, cosine), vec3(0.0f, 0.0f, 1.0f)) * max(cosine, kLeastCosine);
            along_[i] = d.z, across_[i] = d.x / sine;
        }
    }

    vec3 operator()(vec3 direction, vec3 normal) const
    {
        const float cosine = dot(direction, normal), place = (cosine > 0.0f ? min(cosine, 1.0f) : 0.0f) * float(kSteps); // NaN is none
        const int i = min(int(place), kSteps - 1);
        const float part = place - float(i), along = along_[i] + part * (along_[i + 1] - along_[i]),
                    across = across_[i] + part * (across_[i + 1] - across_[i]);
        return ((along - across * cosine) * normal + across * direction) / max(cosine, kLeastCosine);
    }

private:
    static constexpr int kSteps = 1024;
    float along_[kSteps + 1], across_[kSteps + 1];
};
}

void Neighbours::bend(const Lanes3& direction, const Lanes3& light)
{
    static const Leans leans;
    Lanes3 bent;
    for (int i = 0; i < kPacket; i++) {
        const vec3 n = white.normal[i];
        const float bright = luminance(light[i]), comes = dot(direction[i], n);
        bent.set(i, mix(vec3(0.0f), bright * leans(direction[i], n), bvec3((bright > 0.0f) & (comes > 0.0f))));
    }
    for (int i = 0; i < kPacket; i++) turn.add(i, bent[i]);
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

// Light that leaves y by its base, whose law is the same for all who see it but for one factor, into `find`; what leaves it by its other lobes
// towards the path's texel is returned.
static vec3 leaves(Tracer here, Tracer beyond, const Ray& ray, float pdf, Sampler& random, Find& find)
{
    const Hit& hit = find.hit;
    Surface& surface = find.surface;
    find.normal = dot(surface.geometricNormal, ray.direction) < 0.0f ? surface.geometricNormal : -surface.geometricNormal;
    find.position = leaving(surface, find.normal);
    find.any = largestOf(surface.emission) > 0.0f;
    BsdfView view = viewBsdf(surface.bsdf, toLocal(surface.frame, -ray.direction));
    vec3 throughput(1.0f), base;
    if (knownBase(beyond, hit, surface, base)) {
        find.matte = surface.bsdf.diffuse * base;
        find.any = true;
        if (!leaveBase(surface, view, throughput, random)) return vec3(0.0f);
    }
    vec3 matte(0.0f), own(0.0f);
    for (uint category = 0; category < kDirectCategories; category++) {
        LightSample light;
        vec3 wi;
        if (!hasDirect(beyond, category) || !sampleAtSurface(beyond, category, surface, random, light, wi)) continue;
        const BsdfValue value = valueBsdf(surface.bsdf, view, wi);
        const vec3 left = lightThroughSurface(beyond, throughput, surface, value, light, wi),
                   share = baseShare(surface.bsdf, view, wi, value.f);
        matte += share * left;
        own += (1.0f - share) * left;
    }
    Path path = beginPath(ray, pdf, random);
    path.throughput = throughput;
    if (turnAtSurface(settings(beyond), surface, view, hit.distance, path)) {
        const vec3 wi = toLocal(surface.frame, path.ray.direction);
        const bool delta = path.pdf == 0.0f;
        follow(here, beyond, unknownHit(), path);
        const vec3 share = delta ? vec3(0.0f) : baseShare(surface.bsdf, view, wi, valueBsdf(surface.bsdf, view, wi).f);
        matte += share * path.radiance;
        own += (1.0f - share) * path.radiance;
    }
    random = path.random;
    if (view.pass > 0.0f) find.matte += matte / view.pass;
    find.any = find.any || largestOf(find.matte) > 0.0f;
    return own;
}

// Follows texel j's path. Returns the light that is its own, and fills `find` with what its neighbours can use too.
static vec3 explore(Tracer here, Tracer beyond, Neighbours& group, int j, Find& find)
{
    const Ray& ray = group.rays[j];
    const Hit& hit = group.hits[j];
    Sampler& random = group.random[j];
    const float cosine = dot(ray.direction, group.white.normal[j]);
    // Directions behind the geometric surface see only the surface itself
    if (!(cosine > 0.0f) || !(dot(ray.direction, group.white.geometricNormal[j]) > 0.0f)) return vec3(0.0f);
    const float pdf = rarity(cosine * kInvPi);
    const Ray whole{ray.origin, ray.direction, hit.distance};
    if (group.tells && !areSame(here, beyond))
        group.more.add(j, punctualAlong(beyond, whole, 0.0f, pdf) - punctualAlong(here, whole, 0.0f, pdf));
    const bool met = hit.distance < kRayFar;
    if (met) find.surface = surfaceAt(beyond, ray, hit);
    const Surface& surface = find.surface;
    if (met && (surface.bsdf.roughness > 0.0f || surface.absorption != vec3(0.0f)))
        return radianceAlong(here, beyond, ray, hit, pdf, random);

    // Up to y: lights on the way, and media, in which the path may turn before
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

    return own + leaves(here, beyond, ray, pdf, random, find);
}

void gather(Tracer here, Tracer beyond, Neighbours& group)
{
    here.transport->world.closestHits(group.rays, group.hits, group.count, /* coherent= */ false);
    here.rays->closestPacked += std::uint64_t(group.count);
    group.begin();
    gainDirect(here, beyond, group);
    Find finds[kPacket];
    for (int j = 0; j < group.count; j++) group.gain(j, group.rays[j].direction, explore(here, beyond, group, j, finds[j]));
    for (int j = 0; j < group.count; j++)
        if (finds[j].any) share(beyond, group, j, finds[j]);
}
}
