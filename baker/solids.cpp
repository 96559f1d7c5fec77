#include "baker/solids.hpp"
#include "baker/irradiance.hpp"
#include "baker/sphere_sums.hpp"
#include "shaders/sampling.h"
#include <algorithm>

namespace afterglow
{
static constexpr uint kPaths = 1u << 14; // per kind of light
static constexpr uint kBounces = 4;
static constexpr uint kThrough = 8; // surfaces
static constexpr double kBackShare = 0.01;
static constexpr int kAsked = 4;      // rays of every point: none meets a back where a surface lies in the open
static constexpr int kAskedMore = 32; // of every point, where one does
static constexpr int kInside = 4;     // of those meet backs: not all, for other solids reach in

static bool isOpaque(const Material& m) { return !(m.transmission > 0.0f) && (m.flags & (kMaterialAlphaMask | kMaterialAlphaBlend)) == 0; }

static bool meetsBack(const World& world, const Ray& ray, const Hit& hit) { return dot(world.front(hit.triangle), ray.direction) > 0.0f; }

// A ray that enters the level's bounds from far away, along `direction`.
static Ray fromOutside(const Scene& scene, vec3 direction, vec2 u)
{
    float radius = 0.5f * length(scene.upper - scene.lower);
    vec2 disc = radius * sampleDisc(u);
    vec3 start = 0.5f * (scene.lower + scene.upper) - direction * (2.0f * radius);
    return Ray{start + toWorld(makeFrame(direction), vec3(disc.x, disc.y, 0.0f)), direction, kRayFar};
}

// A ray as a light of that category sends it out; only where it goes matters, not how bright it is.
static Ray lightRay(const LightTransport& transport, uint category, Sampler& random)
{
    const Scene& scene = transport.world.scene();
    if (category == kDirectEmitter) {
        float choice = next1(random);
        Emitters::Point lamp = transport.emitters.point(choice, next2(random));
        return cosineRay(whiteSurface(lamp.position, lamp.normal, lamp.normal), next2(random));
    }
    if (category == kDirectSky) {
        vec3 direction = sampleUniformSphere(next2(random));
        return fromOutside(scene, direction, next2(random));
    }
    const std::vector<Light>& lights = transport.lights;
    const Light& light = lights[min(std::size_t(next1(random) * float(lights.size())), lights.size() - 1)];
    if (light.type == kLightDirectional) return fromOutside(scene, light.direction, next2(random));
    return Ray{light.position, sampleUniformSphere(next2(random)), kRayFar};
}

// The objects out of which a ray comes: of those along it, straight through all others, the ones whose back it meets first.
static std::vector<uint> startedIn(const World& world, Ray ray)
{
    std::vector<uint> met, inside;
    for (uint i = 0; i < kThrough; i++) {
        const Hit hit = world.closestHit(ray);
        if (!(hit.distance < kRayFar)) break;
        const uint object = world.triangles()[hit.triangle].object;
        if (std::find(met.begin(), met.end(), object) == met.end()) {
            met.push_back(object);
            if (meetsBack(world, ray, hit)) inside.push_back(object);
        }
        const Surface surface = world.surfaceAt(ray, hit);
        ray.origin = offsetRay(surface.position, -surface.geometricNormal);
    }
    return inside;
}

Solids::Solids(const LightTransport& transport) : world_(transport.world), solid_(transport.world.scene().objects.size())
{
    std::vector<double> met(solid_.size(), 0.0), backs(met);
    bool shines[kDirectCategories] = {!transport.lights.empty(), !transport.emitters.empty(), transport.sky.shines()};
    // Lamps are sunk into ceilings, and things stand on floors that shine: what starts there starts inside. Unless most do: then the room
    // around the lamps is inside out
    uint sunk = 0;
    for (uint path = 0; path < (shines[kDirectEmitter] ? kPaths : 0u); path++) {
        Sampler random = makeSampler(kDirectEmitter, path);
        const Ray ray = lightRay(transport, kDirectEmitter, random);
        const Hit hit = world_.closestHit(ray);
        sunk += hit.distance < kRayFar && meetsBack(world_, ray, hit) ? 1u : 0u;
    }
    for (uint category = 0; category < kDirectCategories; category++) {
        const bool mayStartInside = category == kDirectEmitter && 2 * sunk < kPaths;
        for (uint path = 0; path < (shines[category] ? kPaths : 0u); path++) {
            Sampler random = makeSampler(category, path);
            Ray ray = lightRay(transport, category, random);
            const std::vector<uint> inside = mayStartInside ? startedIn(world_, ray) : std::vector<uint>();
            for (uint bounce = 0; bounce <= kBounces; bounce++) {
                Hit hit = world_.closestHit(ray);
                if (!(hit.distance < kRayFar)) break;
                bool back = meetsBack(world_, ray, hit);
                uint object = world_.triangles()[hit.triangle].object;
                if (back && std::find(inside.begin(), inside.end(), object) != inside.end()) break;
                met[object] += 1.0;
                backs[object] += back ? 1.0 : 0.0;
                Surface surface = world_.surfaceAt(ray, hit);
                bool passes = !isOpaque(world_.materialOf(hit.triangle)) && next1(random) < 0.5f;
                ray =
                    passes
                        ? Ray{leaving(surface, -surface.geometricNormal), ray.direction, kRayFar}
                        : cosineRay(whiteSurface(surface.position, surface.geometricNormal, surface.geometricNormal, surface.meetingError),
                                    next2(random));
            }
        }
    }
    for (std::size_t i = 0; i < solid_.size(); i++) solid_[i] = backs[i] <= kBackShare * met[i];
}

bool Solids::meetsInside(const Ray& ray, const Hit& hit) const
{
    return hit.distance < kRayFar && solid_[world_.triangles()[hit.triangle].object] && isOpaque(world_.materialOf(hit.triangle)) &&
           meetsBack(world_, ray, hit);
}

double Solids::shareInside(vec3 position) const
{
    static const std::array<vec3, 12> kLook = spiral<12>();
    int met = 0, inside = 0;
    for (vec3 direction : kLook) {
        const Ray ray{position, direction, kRayFar};
        const Hit hit = world_.closestHit(ray);
        met += hit.distance < kRayFar ? 1 : 0;
        inside += meetsInside(ray, hit) ? 1 : 0;
    }
    return met > 0 ? double(inside) / double(met) : 0.0;
}

namespace
{
// The rays that are asked of a point; those of a number go the same way from each.
struct Asked {
    vec3 origin;
    Frame frame;

    explicit Asked(const SurfacePlace& point) : origin(leaving(point.position, 0.0f, point.normal)), frame(makeFrame(point.normal)) {}
    Ray operator[](int number) const { return Ray{origin, toWorld(frame, directions()[std::size_t(number)]), kRayFar}; }

private:
    static const std::array<vec3, kAskedMore>& directions() // about the normal
    {
        static const auto made = [] {
            std::array<vec3, kAskedMore> all;
            for (uint number = 0; number < uint(kAskedMore); number++) {
                Sampler random = makeSampler(0, number);
                all[number] = sampleCosineHemisphere(next2(random));
            }
            return all;
        }();
        return made;
    }
};
}

std::vector<Stand> Solids::standsOf(std::span<const SurfacePlace> points) const
{
    Ray rays[kPacket];
    Hit hits[kPacket];
    const std::vector<Asked> asked(points.begin(), points.end());
    bool areOpen = true; // none of them meets a back
    for (std::size_t first = 0; first < points.size(); first += kPacket)
        for (int number = 0; number < kAsked && areOpen; number++) {
            const int count = int(min(points.size() - first, std::size_t(kPacket)));
            for (int i = 0; i < count; i++) rays[i] = asked[first + std::size_t(i)][number];
            world_.closestHits(rays, hits, count);
            for (int i = 0; i < count; i++) areOpen = areOpen && !meetsInside(rays[i], hits[i]);
        }
    std::vector<Stand> stands(points.size(), Stand::open);
    for (std::size_t p = 0; p < points.size() && !areOpen; p++) {
        int backs = 0, oneSided = 0;
        for (int first = 0; first < kAskedMore; first += kPacket) {
            for (int i = 0; i < kPacket; i++) rays[i] = asked[p][first + i];
            world_.closestHits(rays, hits, kPacket, /* coherent= */ false);
            for (int i = 0; i < kPacket; i++) {
                if (!meetsInside(rays[i], hits[i])) continue;
                backs++;
                oneSided += (world_.materialOf(hits[i].triangle).flags & kMaterialDoubleSided) == 0 ? 1 : 0;
            }
        }
        if (backs >= kInside) stands[p] = 2 * oneSided > backs ? Stand::unseen : Stand::inside;
    }
    return stands;
}
}
