// What is asked of Embree, ray by ray and in packets.
#include "baker/world_embree.hpp"
#include <cmath>

namespace afterglow
{
// What Embree can be asked: coordinates up to its FLT_LARGE, and no NaN. Beyond them there is nothing to meet.
constexpr float kFarthest = 1.844e18f;
static bool isNear(float x) { return std::fabs(x) <= kFarthest; } // NaN is not
static bool answerable(const Ray& ray)
{
    return largestOf(abs(ray.origin)) <= kFarthest && largestOf(abs(ray.direction)) <= kFarthest &&
           !std::isnan(dot(ray.origin, vec3(1.0f))) && !std::isnan(dot(ray.direction, vec3(1.0f))) && !std::isnan(ray.far);
}

static void fill(RTCRay& out, const Ray& ray)
{
    out.org_x = ray.origin.x, out.org_y = ray.origin.y, out.org_z = ray.origin.z, out.tnear = 0.0f;
    out.dir_x = ray.direction.x, out.dir_y = ray.direction.y, out.dir_z = ray.direction.z, out.time = 0.0f;
    out.tfar = ray.far, out.mask = ~0u, out.id = 0, out.flags = 0;
}

// A packet of rays, of which the first `count` are asked, where they can be; each carries its number.
static void fill(RTCRay16& out, int* valid, const Ray* rays, int count)
{
    for (int i = 0; i < kPacket; i++) {
        const bool asked = i < count && answerable(rays[i]);
        valid[i] = asked ? -1 : 0;
        const Ray ray = asked ? rays[i] : Ray{vec3(0.0f), vec3(0.0f, 0.0f, 1.0f), 0.0f};
        out.org_x[i] = ray.origin.x, out.org_y[i] = ray.origin.y, out.org_z[i] = ray.origin.z, out.tnear[i] = 0.0f;
        out.dir_x[i] = ray.direction.x, out.dir_y[i] = ray.direction.y, out.dir_z[i] = ray.direction.z, out.time[i] = 0.0f;
        out.tfar[i] = ray.far, out.mask[i] = ~0u, out.id[i] = uint(i), out.flags[i] = 0;
    }
}

Hit World::closestHit(const Ray& ray) const
{
    if (!answerable(ray)) return Hit{kRayFar, 0, vec2(0.0f)};
    RTCRayHit query;
    fill(query.ray, ray);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    Query context = embree_->query(this, /* coherent= */ false, nullptr, nullptr);
#if AFTERGLOW_EMBREE >= 4
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.context = &context.context;
    rtcIntersect1(embree_->scene, &query, &arguments);
#else
    rtcIntersect1(embree_->scene, &context.context, &query);
#endif
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return Hit{kRayFar, 0, vec2(0.0f)};
    return Hit{query.ray.tfar, query.hit.primID + (query.hit.geomID == 1 ? uint(opaque_) : 0u), vec2(query.hit.u, query.hit.v)};
}

void World::closestHits(const Ray* rays, Hit* hits, int count, bool coherent) const
{
    alignas(64) int valid[kPacket];
    alignas(64) RTCRayHit16 packet;
    fill(packet.ray, valid, rays, count);
    for (uint& geometry : packet.hit.geomID) geometry = RTC_INVALID_GEOMETRY_ID;
    Query context = embree_->query(this, coherent, nullptr, nullptr);
#if AFTERGLOW_EMBREE >= 4
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.context = &context.context;
    if (coherent) arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    rtcIntersect16(valid, embree_->scene, &packet, &arguments);
#else
    rtcIntersect16(valid, embree_->scene, &context.context, &packet);
#endif
    for (int i = 0; i < count; i++) {
        bool hit = packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
        uint offset = packet.hit.geomID[i] == 1 ? uint(opaque_) : 0u;
        hits[i] = hit ? Hit{packet.ray.tfar[i], packet.hit.primID[i] + offset, vec2(packet.hit.u[i], packet.hit.v[i])}
                      : Hit{kRayFar, 0, vec2(0.0f)};
    }
}

// Any hit of a packet; packet.tfar is negative where there was one.
void World::Embree::occluded(const World* world, const int* valid, RTCRay16& packet, vec3* tint) const
{
    Query asked = query(world, /* coherent= */ true, nullptr, tint);
#if AFTERGLOW_EMBREE >= 4
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.context = &asked.context;
    arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    rtcOccluded16(valid, scene, &packet, &arguments);
#else
    rtcOccluded16(valid, scene, &asked.context, &packet);
#endif
}

void World::transmittances(const Ray* rays, vec3* passed, int count) const
{
    alignas(64) int valid[kPacket];
    alignas(64) RTCRay16 packet;
    fill(packet, valid, rays, count);
    for (int i = 0; i < count; i++) passed[i] = vec3(1.0f);
    embree_->occluded(this, valid, packet, passed);
    for (int i = 0; i < count; i++)
        if (packet.tfar[i] < 0.0f) passed[i] = vec3(0.0f);
}

static void fill(RTCRay16& out, int* valid, const RayLanes& rays)
{
    for (int i = 0; i < kPacket; i++) {
        const float x = rays.origin.x[i], y = rays.origin.y[i], z = rays.origin.z[i], dx = rays.direction.x[i], dy = rays.direction.y[i],
                    dz = rays.direction.z[i];
        out.org_x[i] = x, out.org_y[i] = y, out.org_z[i] = z, out.tnear[i] = 0.0f;
        out.dir_x[i] = dx, out.dir_y[i] = dy, out.dir_z[i] = dz, out.time[i] = 0.0f;
        out.tfar[i] = rays.far[i], out.mask[i] = ~0u, out.id[i] = uint(i), out.flags[i] = 0;
        valid[i] = isNear(x) & isNear(y) & isNear(z) & isNear(dx) & isNear(dy) & isNear(dz) & (rays.far[i] >= 0.0f) ? rays.asked[i] : 0;
    }
}

void World::transmittances(const RayLanes& rays, Lanes3& passed) const
{
    alignas(64) int valid[kPacket];
    alignas(64) RTCRay16 packet;
    fill(packet, valid, rays);
    vec3 tints[kPacket];
    for (vec3& tint : tints) tint = vec3(1.0f);
    embree_->occluded(this, valid, packet, tints);
    for (int i = 0; i < kPacket; i++) passed.set(i, rays.asked[i] != 0 && packet.tfar[i] < 0.0f ? vec3(0.0f) : tints[i]);
}

void World::unoccluded(RayLanes& rays) const
{
    alignas(64) int valid[kPacket];
    alignas(64) RTCRay16 packet;
    fill(packet, valid, rays);
    embree_->occluded(this, valid, packet, nullptr);
    for (int i = 0; i < kPacket; i++) rays.asked[i] = packet.tfar[i] < 0.0f ? 0 : rays.asked[i];
}

bool World::unoccluded(const Ray& ray) const
{
    alignas(64) int valid[kPacket];
    alignas(64) RTCRay16 packet;
    fill(packet, valid, &ray, 1);
    embree_->occluded(this, valid, packet, nullptr);
    return !(packet.tfar[0] < 0.0f);
}

vec3 World::transmittance(const Ray& ray, const Wavelengths* at) const
{
    if (!answerable(ray)) return vec3(1.0f);
    RTCRay query;
    fill(query, ray);
    vec3 tint(1.0f);
    Query context = embree_->query(this, /* coherent= */ false, at, &tint);
#if AFTERGLOW_EMBREE >= 4
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.context = &context.context;
    rtcOccluded1(embree_->scene, &query, &arguments);
#else
    rtcOccluded1(embree_->scene, &context.context, &query);
#endif
    return query.tfar < 0.0f ? vec3(0.0f) : tint;
}
}
