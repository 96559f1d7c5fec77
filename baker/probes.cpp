#include "baker/probes.hpp"
#include "baker/dilate.hpp"
#include "engine/core/jobs.hpp"
#include "shaders/probe.h"
#include <cmath>

namespace afterglow
{
static constexpr int kMostPerAxis = 64;
static constexpr float kInvalidShare = 0.5f; // of what its rays meet is backs: the probe stands inside a solid, or outside a room

static ivec3 countFor(vec3 extent, float spacing)
{
    return clamp(ivec3(round(extent / max(spacing, 1e-6f))), ivec3(1), ivec3(kMostPerAxis));
}

std::vector<ProbeVolume> placeProbes(const Scene& scene, float spacing)
{
    std::vector<ProbeVolume> volumes;
    for (const ProbeVolumeRequest& asked : scene.probeVolumes) {
        vec3 extent(length(vec3(asked.toWorld[0])), length(vec3(asked.toWorld[1])), length(vec3(asked.toWorld[2])));
        ProbeVolume volume;
        volume.name = asked.name;
        volume.toWorld = asked.toWorld;
        volume.count = countFor(extent, asked.spacing) + 1; // probes on the faces of the box that was asked for
        volume.count = min(volume.count, ivec3(kMostPerAxis));
        volumes.push_back(volume);
    }
    vec3 extent = scene.upper - scene.lower;
    if (!volumes.empty() || !(largestOf(extent) > 0.0f)) return volumes;
    // One volume over everything: a probe in the middle of each cell, so that none lies in the outer walls
    ProbeVolume volume;
    volume.name = "level";
    volume.count = countFor(extent, spacing);
    vec3 cell = extent / vec3(volume.count);
    vec3 box = max(extent - cell, vec3(1e-6f));
    volume.toWorld = mat4(vec4(box.x, 0, 0, 0), vec4(0, box.y, 0, 0), vec4(0, 0, box.z, 0), vec4(0.5f * (scene.lower + scene.upper), 1));
    volumes.push_back(volume);
    return volumes;
}

vec3 probePosition(const ProbeVolume& volume, int index)
{
    ivec3 i(index % volume.count.x, index / volume.count.x % volume.count.y, index / (volume.count.x * volume.count.y));
    return vec3(volume.toWorld * vec4(probeUnitPosition(i, volume.count), 1.0f));
}

struct ProbeSum {
    Sh9 radiance[2] = {shZero(), shZero()}; // two independent halves
    double inverseDistance = 0.0;
    int met = 0, behind = 0; // rays that hit something, and its back
};

static void sampleProbe(BakeContext& context, vec3 position, uint seed, int half, int samples, ProbeSum& sum, RayCount& rays)
{
    Tracer here{&context.transport, &context.direct, &rays};
    Tracer beyond{&context.transport, &context.transport.lights, &rays};
    for (int s = 0; s < samples; s++) {
        Sampler random = makeSampler(hash2(seed, uint(half)), uint(s));
        Ray ray{position, sampleUniformSphere(next2(random)), kRayFar};
        Hit hit = closestHit(beyond, ray);
        if (hit.distance < kRayFar) {
            sum.met++;
            sum.behind += context.solids.meetsInside(ray, hit) ? 1 : 0;
            sum.inverseDistance += 1.0 / double(max(hit.distance, 1e-6f));
        }
        vec3 value = radianceAlong(here, beyond, ray, hit, uniformSpherePdf(), random);
        if (isFinite(value)) shAdd(sum.radiance[half], ray.direction, value / (uniformSpherePdf() * float(samples)));

        // Lights straight from where they are
        for (uint category = 0; category < kDirectCategories; category++) {
            if (!hasDirect(here, category)) continue;
            float choice = next1(random);
            LightSample light = sampleDirect(here, category, position, choice, next2(random));
            if (!(light.pdf > 0.0f)) continue;
            vec3 carried = light.radiance;
            if (light.delta == 0u) carried *= powerHeuristic(light.pdf, uniformSpherePdf()) / light.pdf;
            vec3 met = arriving(here, position, position, light, carried);
            if (isFinite(met)) shAdd(sum.radiance[half], light.direction, met / float(samples));
        }
    }
}

ProbesResult bakeProbes(BakeContext& context, std::vector<ProbeVolume> volumes, int samples)
{
    ProbesResult result;
    struct Outcome {
        Sh9 irradiance;
        float validity = 0.0f, clearance = 0.0f;
        double square = 0.0, mean = 0.0; // of the valid ones: of the half difference, of the radiance
    };
    struct Probe {
        std::size_t volume;
        int index; // in the volume
        Outcome outcome{};
    };
    std::vector<Probe> probes;
    for (std::size_t v = 0; v < volumes.size(); v++) {
        int count = volumes[v].count.x * volumes[v].count.y * volumes[v].count.z;
        volumes[v].irradiance.assign(std::size_t(count), shZero());
        volumes[v].validity.assign(std::size_t(count), 0.0f);
        for (int i = 0; i < count; i++) probes.push_back({v, i});
    }
    context.progress.begin("probes", probes.size(), "probes");
    parallelFor(probes.size(), context.threads, [&](std::size_t i) {
        const Probe& probe = probes[i];
        Outcome& out = probes[i].outcome;
        doUnit(context, {Job::probes, std::uint32_t(i)}, {bytesOf(std::span(&out, 1))}, 1, [&](RayCount& rays) {
            ProbeSum sum;
            uint seed = hash3(context.seed, uint(probe.volume) + 0x9e3779b9u, uint(probe.index));
            for (int half = 0; half < 2; half++)
                sampleProbe(context, probePosition(volumes[probe.volume], probe.index), seed, half, max(samples / 2, 1), sum, rays);
            for (int c = 0; c < 9; c++) out.irradiance.c[c] = 0.5f * (sum.radiance[0].c[c] + sum.radiance[1].c[c]);
            vec3 difference = 0.5f * (sum.radiance[0].c[0] - sum.radiance[1].c[0]);
            bool valid = float(sum.behind) <= kInvalidShare * float(sum.met);
            out.validity = valid ? 1.0f : 0.0f;
            if (valid) {
                out.square = double(dot(difference, difference)) / 3.0;
                out.mean = double(out.irradiance.c[0].x + out.irradiance.c[0].y + out.irradiance.c[0].z) / 3.0;
                out.clearance = sum.inverseDistance > 0.0 ? float(double(samples) / sum.inverseDistance) : kRayFar;
            }
            out.irradiance = shConvolveCosine(out.irradiance);
        });
    });
    context.progress.end();
    double squares = 0.0, means = 0.0;
    for (const Probe& probe : probes) {
        ProbeVolume& volume = volumes[probe.volume];
        volume.irradiance[std::size_t(probe.index)] = probe.outcome.irradiance;
        volume.validity[std::size_t(probe.index)] = probe.outcome.validity;
        result.clearance.push_back(probe.outcome.clearance);
        result.count++;
        if (probe.outcome.validity == 0.0f) continue;
        result.valid++;
        squares += probe.outcome.square;
        means += probe.outcome.mean;
    }
    if (means > 0.0) result.estimatedError = float(std::sqrt(squares / double(result.valid)) / (means / double(result.valid)));
    for (ProbeVolume& volume : volumes) dilate(volume);
    result.volumes = std::move(volumes);
    return result;
}
}
