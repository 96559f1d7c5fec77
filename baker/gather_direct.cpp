#include "baker/gather_direct.hpp"
#include <algorithm>

namespace afterglow
{
// What is done with light that arrives at the texels.
using Take = void (*)(Neighbours& group, const Lanes3& direction, const Lanes3& light);

// `dimension`: of the samplers, that have served so many before.
static DrawLanes draw(const Neighbours& group, uint index, uint dimension)
{
    DrawLanes draws;
    for (int i = 0; i < kPacket; i++) {
        Sampler random = makeSampler(group.lightSeed[i], index);
        random.dimension = dimension;
        draws.choice[i] = next1(random);
        const vec2 where = next2(random);
        draws.x[i] = where.x, draws.y[i] = where.y;
    }
    return draws;
}

// samplePunctual() for all texels.
static void samplePunctuals(const std::vector<Light>& lights, const Neighbours& group, const DrawLanes& draws, LightLanes& samples)
{
    const Lanes3& from = group.white.position;
    Lanes total{}, probability{};
    for (const Light& light : lights)
        for (int i = 0; i < kPacket; i++) total[i] += punctualWeight(light, from[i]);
    Lanes target;
    for (int i = 0; i < kPacket; i++) target[i] = draws.choice[i] * total[i];
    alignas(64) int chosen[kPacket];
    std::fill_n(chosen, kPacket, -1);
    for (int l = 0; l < int(lights.size()); l++) {
        const float beyond = l + 1 < int(lights.size()) ? 0.0f : kFloatMax; // the last one takes what rounding left
        for (int i = 0; i < kPacket; i++) {
            const float weight = punctualWeight(lights[std::size_t(l)], from[i]), left = target[i] - weight, share = weight / total[i];
            const bool takes = (chosen[i] < 0) & (left < beyond) & (weight > 0.0f);
            target[i] = left;
            chosen[i] = takes ? l : chosen[i];
            probability[i] = takes ? share : probability[i];
        }
    }
    for (int i = 0; i < kPacket; i++)
        samples.set(i, i < group.count && chosen[i] >= 0
                           ? sampleChosen(lights[std::size_t(chosen[i])], from[i], vec2(draws.x[i], draws.y[i]), probability[i])
                           : noLight());
}

static void sample(Tracer here, uint category, const Neighbours& group, const DrawLanes& draws, LightLanes& samples)
{
    if (category == kDirectPunctual) return samplePunctuals(*here.lights, group, draws, samples);
    if (category == kDirectEmitter) return here.transport->emitters.sample(group.white.position, draws, samples);
    for (int i = 0; i < kPacket; i++) samples.set(i, i < group.count ? sampleSky(here, vec2(draws.x[i], draws.y[i])) : noLight());
}

// The rays to the samples, and what each texel gains where nothing is in the way: lightThroughSurface() of a white surface. What touches the
// texel is not asked for.
static void aim(const WhiteLanes& white, const LightLanes& lights, RayLanes& rays, Lanes3& carried)
{
    rays.origin = white.origin;
    for (int i = 0; i < kPacket; i++) {
        const LightSample light = lights[i];
        const Ray ray = rayToLight(white.position[i], white.origin[i], light);
        const float here = dot(light.direction, white.normal[i]), above = dot(light.direction, white.geometricNormal[i]);
        const bool comes = (light.pdf > 0.0f) & (here > 0.0f) & (above > 0.0f); // a shading normal must not let light through a wall
        const float weight = powerHeuristic(light.pdf, rarity(here * kInvPi)) / light.pdf;
        const float gain = kInvPi / float(kLightSamples) * here * (lights.delta[i] > 0.0f ? 1.0f : weight);
        const vec3 arriving = gain * light.radiance;
        carried.set(i, mix(vec3(0.0f), arriving, bvec3(comes)));
        rays.direction.set(i, ray.direction);
        rays.far[i] = ray.far;
    }
    for (int i = 0; i < kPacket; i++) {
        const float light = carried.x[i] + carried.y[i] + carried.z[i];
        rays.asked[i] = (light > 0.0f) & (rays.far[i] > 0.0f) ? -1 : 0;
    }
}

static void dimByMedia(Tracer here, RayLanes& rays, Lanes3& carried)
{
    for (int i = 0; i < kPacket; i++) {
        if (rays.asked[i] == 0) continue;
        carried.set(i, carried[i] * mediaTransmittance(here, Ray{rays.origin[i], rays.direction[i], rays.far[i]}));
        if (!(largestOf(carried[i]) > 0.0f)) rays.asked[i] = 0; // light that they swallow costs no ray
    }
}

static void eachSample(Tracer here, Neighbours& group, Take take)
{
    LightLanes light;
    RayLanes rays;
    Lanes3 carried, passed;
    for (uint k = 0; k < uint(kLightSamples); k++)
        for (uint category = 0, dimension = 0; category < kDirectCategories; category++) {
            if (!hasDirect(here, category)) continue;
            sample(here, category, group, draw(group, group.sample * uint(kLightSamples) + k, dimension), light);
            dimension += 2;
            aim(group.white, light, rays, carried);
            if (mediumCount(airOf(here)) > 0u) dimByMedia(here, rays, carried);
            for (const int asked : rays.asked) here.rays->shadowPacked += asked != 0 ? 1u : 0u;
            here.transport->world.transmittances(rays, passed);
            for (int i = 0; i < kPacket; i++) carried.set(i, carried[i] * passed[i]);
            take(group, rays.direction, carried);
        }
}

// Of light from there, what the layer lets in, times the base's gain.
static float letIn(const Neighbours& group, int i, vec3 direction)
{
    const Bsdf& base = group.base[i];
    return base.layerEdge > 0.0f ? basePass(base, max(dot(direction, group.white.normal[i]), 0.0f)) * base.baseGain : 1.0f;
}

static void gain(Neighbours& group, const Lanes3& direction, const Lanes3& light) { group.gain(direction, light); }
static void gainAndTell(Neighbours& group, const Lanes3& direction, const Lanes3& light)
{
    group.gain(direction, light);
    for (int i = 0; i < group.count; i++) group.more.add(i, (letIn(group, i, direction[i]) - 1.0f) * light[i]);
}
static void gainApart(Neighbours& group, const Lanes3& direction, const Lanes3& light)
{
    group.gain(direction, light);
    for (int i = 0; i < group.count; i++) group.more.add(i, -light[i]);
}
static void tell(Neighbours& group, const Lanes3& direction, const Lanes3& light)
{
    for (int i = 0; i < group.count; i++) group.more.add(i, letIn(group, i, direction[i]) * light[i]);
}

void gainDirect(Tracer here, Tracer beyond, Neighbours& group)
{
    if (!group.tells || areSame(here, beyond)) return eachSample(here, group, group.tells ? gainAndTell : gain);
    eachSample(here, group, gainApart);
    eachSample(beyond, group, tell);
}
}
