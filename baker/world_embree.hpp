// Inside of World: the level as Embree (3 or 4) holds it. Triangles that may let light through live in a geometry of their own with a filter.
#pragma once
#include "baker/world.hpp"
#include <atomic>
#if AFTERGLOW_EMBREE >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace afterglow
{
#if AFTERGLOW_EMBREE >= 4
using QueryContext = RTCRayQueryContext;
#else
using QueryContext = RTCIntersectContext;
#endif

// What a query carries to the filter; the tint is gathered only by transmittance().
struct Query {
    QueryContext context; // first, so that the filter finds us behind it
    const World* world;
    const Wavelengths* at;
    vec3* tint; // of the ray whose id is 0
};

struct World::Embree {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::vector<float> positions; // xyz, with the 16 bytes of padding that Embree's loads want
    std::vector<uint> opaque, filtered;
    std::atomic<std::int64_t> bytes{0}; // that Embree holds

    ~Embree()
    {
        if (scene) rtcReleaseScene(scene);
        if (device) rtcReleaseDevice(device);
    }

    void attach(const std::vector<uint>& indices, const World* world)
    {
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, positions.data(), 0, 12,
                                   world->vertices_.size());
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, indices.data(), 0, 12, indices.size() / 3);
        if (&indices == &filtered) {
            rtcSetGeometryIntersectFilterFunction(geometry, filter);
            rtcSetGeometryOccludedFilterFunction(geometry, filter);
        }
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(scene, geometry, &indices == &filtered ? 1 : 0);
        rtcReleaseGeometry(geometry);
    }

    static void filter(const RTCFilterFunctionNArguments* args)
    {
        const Query& query = *reinterpret_cast<const Query*>(args->context);
        for (uint i = 0; i < args->N; i++) {
            if (args->valid[i] == 0) continue;
            uint triangle = uint(query.world->opaque_) + RTCHitN_primID(args->hit, args->N, i);
            vec2 b(RTCHitN_u(args->hit, args->N, i), RTCHitN_v(args->hit, args->N, i));
            vec3 direction(RTCRayN_dir_x(args->ray, args->N, i), RTCRayN_dir_y(args->ray, args->N, i),
                           RTCRayN_dir_z(args->ray, args->N, i));
            if (query.world->letsThrough(triangle, b, direction, query.at,
                                         query.tint ? &query.tint[RTCRayN_id(args->ray, args->N, i)] : nullptr))
                args->valid[i] = 0;
        }
    }

    static bool count(void* embree, ssize_t bytes, bool)
    {
        static_cast<Embree*>(embree)->bytes += bytes;
        return true;
    }

    void occluded(const World* world, const int* valid, RTCRay16& packet, vec3* tint) const;

    Query query(const World* world, bool coherent, const Wavelengths* at, vec3* tint) const
    {
        Query made;
        made.world = world;
        made.at = at;
        made.tint = tint;
#if AFTERGLOW_EMBREE >= 4
        (void)coherent;
        rtcInitRayQueryContext(&made.context);
#else
        rtcInitIntersectContext(&made.context);
        made.context.flags = coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
#endif
        return made;
    }
};
}
