#include "baker/gather_direct.hpp"

namespace afterglow
{
// What is done with light that arrives at texel i.
using Take = void (*)(Neighbours& group, int i, vec3 direction, vec3 light);

// One sample of a category for each texel; their shadow rays wait in here.later.
static void aim(Tracer here, uint category, Neighbours& group, Sampler* random, Take take)
{
    for (int i = 0; i < group.count; i++) {
        const Surface& white = group.white[i];
        here.later->path = uint(i);
        LightSample light;
        vec3 wi;
        if (!sampleAtSurface(here, category, white, random[i], light, wi)) continue;
        BsdfValue value = valueBsdf(white.bsdf, viewBsdf(white.bsdf, vec3(0.0f, 0.0f, 1.0f)), wi);
        value.pdf = rarity(value.pdf);
        take(group, i, light.direction, lightThroughSurface(here, vec3(1.0f / float(kLightSamples)), white, value, light, wi));
    }
}

// Asks for the shadow rays, and gives what arrives.
static void arrive(Tracer here, Neighbours& group, Take take)
{
    const std::vector<ShadowRays::Sent>& sent = here.later->sent;
    const int count = int(sent.size());
    if (count == 0) return;
    Ray rays[kPacket];
    vec3 passed[kPacket];
    for (int k = 0; k < count; k++) rays[k] = sent[std::size_t(k)].ray;
    here.transport->world.transmittances(rays, passed, count);
    here.rays->shadowPacked += std::uint64_t(count);
    for (int k = 0; k < count; k++)
        take(group, int(sent[std::size_t(k)].path), rays[k].direction, sent[std::size_t(k)].carried * passed[k]);
    here.later->sent.clear();
}

static void eachSample(Tracer here, Neighbours& group, Take take)
{
    ShadowRays shadows;
    here.later = &shadows;
    for (uint k = 0; k < uint(kLightSamples); k++) {
        Sampler random[kPacket];
        for (int i = 0; i < group.count; i++) random[i] = makeSampler(group.lightSeed[i], group.sample * uint(kLightSamples) + k);
        for (uint category = 0; category < kDirectCategories; category++) {
            if (!hasDirect(here, category)) continue;
            aim(here, category, group, random, take);
            arrive(here, group, take);
        }
    }
}

// Of light from there, what the layer lets in, times the base's gain.
static float letIn(const Neighbours& group, int i, vec3 direction)
{
    const Bsdf& base = group.base[i];
    return base.layerEdge > 0.0f ? basePass(base, max(dot(direction, group.white[i].frame.normal), 0.0f)) * base.baseGain : 1.0f;
}

static void gain(Neighbours& group, int i, vec3 direction, vec3 light) { group.gain(i, direction, light); }
static void gainAndTell(Neighbours& group, int i, vec3 direction, vec3 light)
{
    group.gain(i, direction, light);
    group.more.add(i, (letIn(group, i, direction) - 1.0f) * light);
}
static void gainApart(Neighbours& group, int i, vec3 direction, vec3 light)
{
    group.gain(i, direction, light);
    group.more.add(i, -light);
}
static void tell(Neighbours& group, int i, vec3 direction, vec3 light) { group.more.add(i, letIn(group, i, direction) * light); }

void gainDirect(Tracer here, Tracer beyond, Neighbours& group)
{
    if (!group.tells || areSame(here, beyond)) return eachSample(here, group, group.tells ? gainAndTell : gain);
    eachSample(here, group, gainApart);
    eachSample(beyond, group, tell);
}
}
