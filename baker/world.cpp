// The only file that includes Embree (3 or 4). Triangles that may let light through live in a geometry of their own with a filter.
#include "baker/world.hpp"
#include "engine/core/error.hpp"
#include "shaders/ray_scene.h"
#include <algorithm>
#include <atomic>
#include <cmath>
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

World::World(const Scene& scene, Content content) : scene_(scene), embree_(std::make_unique<Embree>())
{
    // Flatten the instances into world space
    std::vector<Triangle> filtered;
    std::vector<uint> filteredOrder;
    uint triangle = 0;
    const std::vector<Instance> all = instances(scene);
    for (uint number = 0; number < all.size(); number++) {
        const Instance& instance = all[number];
        if (content == Content::staticOnly && (instance.flags & kInstanceStatic) == 0) continue;
        placed_.push_back(instance);
        uint lowest = ~0u, highest = 0;
        for (uint i = 0; i < instance.indexCount; i++) {
            lowest = std::min(lowest, scene.indices[instance.firstIndex + i]);
            highest = std::max(highest, scene.indices[instance.firstIndex + i]);
        }
        if (instance.indexCount == 0) continue;
        uint base = uint(vertices_.size());
        for (uint i = lowest; i <= highest; i++) vertices_.push_back(placedVertex(instance, scene.vertices[instance.firstVertex + i]));
        const bool mayPass = mayLetThrough(scene.materials[instance.material]);
        auto& target = mayPass ? filtered : triangles_;
        auto& targetOrder = mayPass ? filteredOrder : order_;
        for (uint i = 0; i + 2 < instance.indexCount; i += 3) {
            const uint* corner = &scene.indices[instance.firstIndex + i];
            target.push_back({{corner[0] - lowest + base, corner[1] - lowest + base, corner[2] - lowest + base},
                              instance.material,
                              instance.object,
                              number});
            targetOrder.push_back(triangle++);
        }
    }
    opaque_ = triangles_.size();
    triangles_.insert(triangles_.end(), filtered.begin(), filtered.end());
    order_.insert(order_.end(), filteredOrder.begin(), filteredOrder.end());

    embree_->device = rtcNewDevice("threads=1,set_affinity=0");
    if (!embree_->device) throw Error("Embree could not start on this processor; a CPU with SSE2 is needed", Exit::noDevice);
    rtcSetDeviceMemoryMonitorFunction(embree_->device, Embree::count, embree_.get());
    embree_->scene = rtcNewScene(embree_->device);
    rtcSetSceneBuildQuality(embree_->scene, RTC_BUILD_QUALITY_MEDIUM);
    rtcSetSceneFlags(embree_->scene, RTC_SCENE_FLAG_ROBUST); // no light through the edges that closed rooms are made of
    embree_->positions.reserve(vertices_.size() * 3 + 4);
    for (const Vertex& v : vertices_) embree_->positions.insert(embree_->positions.end(), {v.position.x, v.position.y, v.position.z});
    embree_->positions.resize(vertices_.size() * 3 + 4);
    for (std::size_t i = 0; i < triangles_.size(); i++) {
        auto& indices = i < opaque_ ? embree_->opaque : embree_->filtered;
        indices.insert(indices.end(), triangles_[i].vertex, triangles_[i].vertex + 3);
    }
    if (!embree_->opaque.empty()) embree_->attach(embree_->opaque, this);
    if (!embree_->filtered.empty()) embree_->attach(embree_->filtered, this);
    rtcCommitScene(embree_->scene);
}

World::~World() = default;

std::uint64_t World::bytes() const
{
    const auto of = [](const auto& list) { return std::uint64_t(list.capacity()) * sizeof list[0]; };
    return of(placed_) + of(order_) + of(vertices_) + of(triangles_) + of(embree_->positions) + of(embree_->opaque) +
           of(embree_->filtered) + std::uint64_t(std::max(embree_->bytes.load(), std::int64_t(0)));
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
    for (int i = 0; i < kPacket; i++) passed.set(i, packet.tfar[i] < 0.0f ? vec3(0.0f) : tints[i]);
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
