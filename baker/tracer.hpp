// The offline tracer: what shaders/transport.h asks of its includer, answered by Embree. Including this file is including the estimator.
#pragma once
#include "baker/emitters.hpp"
#include "baker/light_cache.hpp"
#include "baker/ray_count.hpp"
#include "baker/sky.hpp"
#include "baker/wavelengths.hpp"
#include "baker/world.hpp"
#include "engine/core/interrupt.hpp"
#include "shaders/path.h"
#include <atomic>

namespace afterglow
{
// Samples that are not are dropped: the mean is over what is finite.
inline bool isFinite(vec3 sample) { return dot(sample, sample) < kFloatMax; }

// Everything a path needs, shared by all threads and never written while they run.
struct LightTransport {
    const World& world;
    Emitters emitters;
    SkyLight sky;
    std::vector<Light> lights; // punctual lights that paths meet
    std::vector<Light> none;   // what a camera sees of them
    std::vector<Medium> media;
    std::vector<vec4> mediumPlanes;
    PathSettings limits = defaultPathSettings();

    LightTransport(const World& w, std::vector<Light> seen)
        : world(w), emitters(w), sky(w.scene().sky), lights(std::move(seen)), media(w.scene().media), mediumPlanes(w.scene().mediumPlanes)
    {
        for (const Medium& medium : media) limits.glow |= uint(medium.emission != vec3(0.0f));
    }
};
}

namespace afterglow
{
// What next-event estimation brought, by the directions that it came from.
struct Arrivals {
    struct Arrival {
        vec3 direction;
        vec3 value;
    };
    Arrival of[kDirectCategories];
    uint count = 0;
};

// Shadow rays that are asked for later, all at once (waves.hpp).
struct ShadowRays {
    struct Sent {
        Ray ray;
        vec3 carried; // radiance that the path gains where nothing is in the way
        uint path;
    };
    std::vector<Sent> sent;
    uint path = 0; // whose step is being taken
};
}

namespace shared
{
// One thread's view, by value as the estimator passes it.
struct Tracer {
    const afterglow::LightTransport* transport;
    const std::vector<Light>* lights;             // those that next-event estimation asks
    afterglow::RayCount* rays;                    // counted
    const afterglow::Wavelengths* at = nullptr;   // what the three channels of this path are; null: Rec.709
    afterglow::ShadowRays* later = nullptr;       // null: shadow rays are asked for at once
    afterglow::Arrivals* arrivals = nullptr;      // null: nobody asks where light comes from
    const afterglow::LightCache* cache = nullptr; // null: paths are traced to their end
    int half = 0;                                 // of the bake, that looks light up
};

// The media, as shaders/media.h asks for them.
struct Air {
    const afterglow::LightTransport* transport;
    const afterglow::Wavelengths* at;
};
FN uint mediumCount(Air air) { return uint(air.transport->media.size()); }
FN Medium mediumAt(Air air, uint i) { return afterglow::seenAt(air.at, air.transport->media[i]); }
FN vec4 mediumPlaneAt(Air air, uint i) { return air.transport->mediumPlanes[i]; }

FN Hit closestHit(Tracer tracer, Ray ray)
{
    ++tracer.rays->closest;
    afterglow::stopIfInterrupted(); // a path through dense fog is long
    return tracer.transport->world.closestHit(ray);
}
FN vec3 unshadowed(Tracer tracer, Ray ray, vec3 carried)
{
    if (tracer.later) {
        tracer.later->sent.push_back({ray, carried, tracer.later->path});
        return vec3(0.0f);
    }
    ++tracer.rays->shadow;
    const vec3 passed = carried * tracer.transport->world.transmittance(ray, tracer.at);
    if (tracer.arrivals) tracer.arrivals->of[tracer.arrivals->count++] = {ray.direction, passed};
    return passed;
}
FN Surface surfaceAt(Tracer tracer, Ray ray, Hit hit) { return afterglow::seenAt(tracer.at, tracer.transport->world.surfaceAt(ray, hit)); }
FN uint lightCount(Tracer tracer) { return uint(tracer.lights->size()); }
FN Light lightAt(Tracer tracer, uint i) { return (*tracer.lights)[i]; }
FN bool hasDirect(Tracer tracer, uint category)
{
    if (category == kDirectPunctual) return !tracer.lights->empty();
    return category == kDirectEmitter ? !tracer.transport->emitters.empty() : tracer.transport->sky.sampled();
}
FN LightSample sampleEmitter(Tracer tracer, vec3 from, float choice, vec2 u)
{
    return afterglow::seenAt(tracer.at, tracer.transport->emitters.sample(from, choice, u));
}
FN float emitterPdf(Tracer tracer, const Ray& ray, const Hit& hit, const Surface& surface)
{
    return tracer.transport->emitters.pdf(ray, hit, surface);
}
FN vec3 skyRadiance(Tracer tracer, vec3 direction)
{
    const vec3 radiance = tracer.transport->sky.radiance(direction);
    return tracer.at ? tracer.at->power * radiance : radiance;
}
FN LightSample sampleSky(Tracer tracer, vec2 u) { return afterglow::seenAt(tracer.at, tracer.transport->sky.sample(u)); }
FN float skyPdf(Tracer tracer, vec3 direction) { return tracer.transport->sky.pdf(direction); }
FN Air airOf(Tracer tracer) { return {tracer.transport, tracer.at}; }
FN PathSettings settings(Tracer tracer) { return tracer.transport->limits; }
FN bool knownBase(Tracer tracer, const Hit& hit, const Surface& surface, vec3& light)
{
    if (!tracer.cache || !(surface.frontFacing > 0.0f) || surface.bsdf.roughness > 0.0f || !(largestOf(surface.bsdf.diffuse) > 0.0f))
        return false;
    return tracer.cache->find(tracer.transport->world, hit, surface.frame.normal, tracer.half, light);
}
FN void cutShort(Tracer tracer) { ++tracer.rays->cut; }
}

#include "shaders/transport.h"
