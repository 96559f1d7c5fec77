#include "baker/sharing.hpp"
#include "baker/gather_direct.hpp"

namespace afterglow
{
namespace
{
// y as the texels see it.
struct Sights {
    RayLanes rays; // to y; `asked` where it is in front
    Lanes cosine;  // at y
    Lanes pdf;     // of the texel's rays, by solid angle
    Lanes density; // the same by area at y; of the sky, by solid angle. 0: unseen
    Lanes3 passed; // what media on the way leave, if there are any
    bool air = false;
};
}

// Towards a point of the level, if nothing is in the way.
static void seePoint(const WhiteLanes& facing, vec3 position, vec3 normal, Sights& sights)
{
    RayLanes& rays = sights.rays;
    for (int i = 0; i < kPacket; i++) {
        const float x = position.x - facing.origin.x[i], y = position.y - facing.origin.y[i], z = position.z - facing.origin.z[i],
                    squared = x * x + y * y + z * z, distance = std::sqrt(squared), inverse = 1.0f / distance;
        const float dx = x * inverse, dy = y * inverse, dz = z * inverse;
        const float there = -(dx * normal.x + dy * normal.y + dz * normal.z),
                    here = dx * facing.normal.x[i] + dy * facing.normal.y[i] + dz * facing.normal.z[i],
                    above = dx * facing.geometricNormal.x[i] + dy * facing.geometricNormal.y[i] + dz * facing.geometricNormal.z[i];
        const bool seen = (squared > 0.0f) & (there > 0.0f) & (here > 0.0f) & (above > 0.0f); // NaN is not
        const float pdf = here * kInvPi;
        rays.direction.x[i] = dx, rays.direction.y[i] = dy, rays.direction.z[i] = dz;
        rays.far[i] = distance;
        rays.asked[i] = seen ? -1 : 0;
        sights.cosine[i] = there;
        sights.pdf[i] = pdf;
        sights.density[i] = seen ? pdf * there * (inverse * inverse) : 0.0f;
    }
}

static void seeSky(const WhiteLanes& facing, vec3 direction, Sights& sights)
{
    RayLanes& rays = sights.rays;
    for (int i = 0; i < kPacket; i++) {
        const float here = direction.x * facing.normal.x[i] + direction.y * facing.normal.y[i] + direction.z * facing.normal.z[i],
                    above = direction.x * facing.geometricNormal.x[i] + direction.y * facing.geometricNormal.y[i] +
                            direction.z * facing.geometricNormal.z[i];
        const bool seen = (here > 0.0f) & (above > 0.0f);
        const float pdf = here * kInvPi;
        rays.direction.x[i] = direction.x, rays.direction.y[i] = direction.y, rays.direction.z[i] = direction.z;
        rays.far[i] = kRayFar;
        rays.asked[i] = seen ? -1 : 0;
        sights.pdf[i] = pdf;
        sights.density[i] = seen ? pdf : 0.0f;
    }
}

// Drops those who do not see y; texel j does.
static void clear(Tracer beyond, int j, bool sky, Sights& sights)
{
    RayLanes rays = sights.rays;
    int count = 0;
    rays.asked[j] = 0;
    for (int i = 0; i < kPacket; i++) {
        count -= rays.asked[i];
        rays.far[i] = sky ? kRayFar : rays.far[i] * (1.0f - kShadowShortening);
    }
    if (count > 0) beyond.transport->world.unoccluded(rays);
    beyond.rays->shadowPacked += std::uint64_t(count);
    rays.asked[j] = -1;
    for (int i = 0; i < kPacket; i++) sights.density[i] = rays.asked[i] ? sights.density[i] : 0.0f;
}

static void throughMedia(Tracer beyond, Sights& sights)
{
    sights.air = mediumCount(airOf(beyond)) > 0u;
    for (int i = 0; sights.air && i < kPacket; i++)
        sights.passed.set(i, sights.density[i] > 0.0f
                                 ? mediaTransmittance(beyond, Ray{sights.rays.origin[i], sights.rays.direction[i], sights.rays.far[i]})
                                 : vec3(0.0f));
}

// Radiance of y towards each texel, weighted against the light samples that the texel itself took.
static void radianceOf(Tracer beyond, const Find& find, const Sights& sights, Lanes3& light)
{
    if (find.sky) {
        const vec3 radiance = skyRadiance(beyond, -find.normal);
        const float other = skyPdf(beyond, -find.normal);
        for (int i = 0; i < kPacket; i++)
            light.set(i, sights.density[i] > 0.0f ? radiance * powerHeuristic(rarity(sights.pdf[i]), other) : vec3(0.0f));
        return;
    }
    const bool layered = find.surface.bsdf.layerEdge > 0.0f, emits = largestOf(find.surface.emission) > 0.0f;
    for (int i = 0; i < kPacket; i++) light.x[i] = find.matte.x, light.y[i] = find.matte.y, light.z[i] = find.matte.z;
    for (int i = 0; layered && i < kPacket; i++)
        if (sights.density[i] > 0.0f) light.set(i, find.matte * basePass(find.surface.bsdf, sights.cosine[i]));
    for (int i = 0; emits && i < kPacket; i++) {
        if (!(sights.density[i] > 0.0f)) continue;
        const Ray ray{sights.rays.origin[i], sights.rays.direction[i], kRayFar};
        const Hit hit{sights.rays.far[i], find.hit.triangle, find.hit.barycentric};
        light.add(i, emissionAlong(beyond, ray, hit, find.surface, rarity(sights.pdf[i])));
    }
}

void share(Tracer beyond, Neighbours& group, int j, const Find& find)
{
    Sights sights;
    sights.rays.origin = group.white.origin;
    if (find.sky)
        seeSky(group.white, -find.normal, sights);
    else
        seePoint(group.white, find.position, find.normal, sights);
    clear(beyond, j, find.sky, sights);
    throughMedia(beyond, sights);

    float total = 0.0f; // density with which rays of all texels end at y, past the media
    for (int i = 0; i < kPacket; i++) total += sights.density[i] * (sights.air ? meanOf(sights.passed[i]) : 1.0f);
    if (!(total > 0.0f)) return; // rounding alone: j's own ray ended there
    Lanes3 light;
    radianceOf(beyond, find, sights, light);
    if (sights.air)
        for (int i = 0; i < kPacket; i++) light.set(i, light[i] * sights.passed[i]);
    const float whole = 1.0f / total;
    for (int i = 0; i < kPacket; i++) {
        const float share = sights.density[i] * whole;
        light.x[i] *= share, light.y[i] *= share, light.z[i] *= share;
        group.irradiance.x[i] += light.x[i], group.irradiance.y[i] += light.y[i], group.irradiance.z[i] += light.z[i];
    }
    if (group.directional) group.bend(sights.rays.direction, light);
}
}
