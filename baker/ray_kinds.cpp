#include "baker/ray_kinds.hpp"
#include "baker/irradiance.hpp"
#include "engine/core/error.hpp"
#include <algorithm>

namespace afterglow
{
constexpr float kTexel = 1.0f / 16.0f; // m: a bake of medium quality
constexpr double kLeastTexels = 64e3;  // that it gives a small level

// Seeds: each kind has its own points.
enum : uint { kIncoherentSeed = 11, kPacketSeed, kShadowSeed, kShadowPacketSeed };

RayKinds::RayKinds(const LightTransport& transport) : transport_(transport), area_(transport.world)
{
    if (!(area_.whole() > 0.0)) throw Error("the level has no static surface to start rays from: choose another level");
    texel_ = std::min(kTexel, float(std::sqrt(area_.whole() / kLeastTexels)));
}

Surface RayKinds::point(Sampler& random) const
{
    const World& world = transport_.world;
    const AreaPoint at = area_.point(random);
    vec3 away[3]; // from the point to the corners
    for (int c = 0; c < 3; ++c) away[c] = world.vertices()[world.triangles()[at.triangle].vertex[c]].position - at.position;
    const vec3 normal = safeNormalize(world.front(at.triangle), vec3(0.0f, 1.0f, 0.0f));
    return whiteSurface(at.position, normal, normal, meetingError(away[0], away[1], away[2]));
}

std::vector<Ray> RayKinds::incoherent(std::size_t count) const
{
    std::vector<Ray> rays;
    for (uint i = 0; i < count; ++i) {
        Sampler random = makeSampler(kIncoherentSeed, i);
        const Surface from = point(random);
        rays.push_back(cosineRay(from, next2(random)));
    }
    return rays;
}

// As many points as a packet has rays, a texel apart.
std::vector<Surface> RayKinds::square(Sampler& random) const
{
    const Surface centre = point(random);
    std::vector<Surface> points(kPacket, centre);
    for (int k = 0; k < kPacket; ++k)
        points[std::size_t(k)].position +=
            texel_ * ((float(k % 4) - 1.5f) * centre.frame.tangent + (float(k / 4) - 1.5f) * centre.frame.bitangent);
    return points;
}

std::vector<Ray> RayKinds::packets(std::size_t count) const
{
    std::vector<Ray> rays;
    for (uint i = 0; i < count / kPacket; ++i) {
        Sampler random = makeSampler(kPacketSeed, i);
        for (const Surface& from : square(random)) rays.push_back(cosineRay(from, next2(random)));
    }
    return rays;
}

std::vector<Ray> RayKinds::shadowPackets(std::size_t count) const
{
    std::vector<Ray> rays;
    for (uint i = 0; rays.size() < count; ++i) {
        Sampler random = makeSampler(kShadowPacketSeed, i);
        const std::vector<Surface> points = square(random);
        const Ray found = cosineRay(points[std::size_t(next1(random) * float(kPacket))], next2(random));
        const float far = transport_.world.closestHit(found).distance;
        for (const Surface& from : points) {
            const Ray leaving = cosineRay(from, vec2(0.5f)); // for its origin
            const vec3 towards = found.origin + found.direction * far - leaving.origin;
            rays.push_back(far < kRayFar ? Ray{leaving.origin, normalize(towards), length(towards) * (1.0f - kShadowShortening)}
                                         : Ray{leaving.origin, found.direction, kRayFar});
        }
    }
    return rays;
}

Ray RayKinds::towardsLight(const Surface& from, Sampler& random) const
{
    RayCount ignored;
    const Tracer tracer{&transport_, &transport_.lights, &ignored};
    const vec3 origin = leaving(from, from.geometricNormal);
    const uint first = uint(3.0f * next1(random)); // the bake asks all three categories; here each comes first equally often
    for (uint k = 0; k < 3u; ++k) {
        const uint category = (first + k) % 3u;
        const LightSample light = sampleDirect(tracer, category, origin, next1(random), next2(random));
        if (!(light.pdf > 0.0f) || !(dot(light.direction, from.geometricNormal) > 0.0f)) continue;
        const float far = light.distance < kRayFar ? light.distance * (1.0f - kShadowShortening) : kRayFar;
        return Ray{origin, light.direction, far};
    }
    return Ray{origin, vec3(0.0f), 0.0f}; // none
}

std::vector<Ray> RayKinds::shadow(std::size_t count) const
{
    constexpr uint kTries = 4; // rays a point may cost: a level without lights still answers
    std::vector<Ray> rays;
    for (uint i = 0; rays.size() < count; ++i) {
        Sampler random = makeSampler(kShadowSeed, i);
        const Surface from = point(random);
        Ray ray = towardsLight(from, random);
        if (!(ray.far > 0.0f) && i >= kTries * count) {
            const vec3 towards = point(random).position - ray.origin;
            ray = Ray{ray.origin, safeNormalize(towards, from.geometricNormal), length(towards) * (1.0f - kShadowShortening)};
        }
        if (ray.far > 0.0f) rays.push_back(ray);
    }
    return rays;
}
}
