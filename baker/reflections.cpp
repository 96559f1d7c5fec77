// This work is based on: Karis 2013 (prefiltering with n = v), Krivanek & Colbert 2008 (mips chosen by the density of the samples).
#include "baker/reflections.hpp"
#include "baker/cube.hpp"
#include "engine/core/jobs.hpp"
#include "shaders/microfacet.h"
#include "shaders/reflection.h"
#include <algorithm>
#include <cmath>

namespace afterglow
{
static constexpr int kPrefilterSamples = 256;
static constexpr int kSmallestFace = 4; // texels, edge of the last mip: roughness 1 needs no more

// Radiance averaged over the GGX lobe of `roughness` seen head-on (n = v = r); each sample reads the box-filtered level that its solid
// angle covers.
static vec3 prefiltered(const std::vector<std::vector<vec3>>& levels, int size, vec3 normal, float roughness)
{
    Frame frame = makeFrame(normal);
    vec2 alpha = roughnessToAlpha(roughness, 0.0f);
    const vec3 view(0.0f, 0.0f, 1.0f);
    vec3 sum(0.0f);
    float weights = 0.0f;
    for (int i = 0; i < kPrefilterSamples; i++) {
        Sampler random = makeSampler(0x51ab1eu, uint(i));
        vec3 l = mirrorDirection(view, sampleGgxVisible(view, alpha, next2(random)));
        if (!(l.z > 0.0f)) continue;
        float solidAngle = 1.0f / (float(kPrefilterSamples) * max(ggxReflectPdf(view, l, alpha), 1e-6f));
        float texel = 4.0f * kPi / (6.0f * float(size) * float(size));
        int level = clamp(int(std::lround(0.5f * std::log2(max(solidAngle / texel, 1.0f)))), 0, int(levels.size()) - 1);
        sum += cubeRadiance(levels[std::size_t(level)], size >> level, toWorld(frame, l)) * l.z;
        weights += l.z;
    }
    return weights > 0.0f ? sum / weights : vec3(0.0f);
}

static int mipCount(int size)
{
    int count = 1;
    while ((size >> count) >= kSmallestFace) count++;
    return count;
}

static void prefilter(BakeContext& context, ReflectionProbe& probe)
{
    // Box-filtered copies of the sharp image, for samples that stand for many texels
    std::vector<std::vector<vec3>> levels{probe.mips[0]};
    for (int edge = probe.size / 2; edge >= 1; edge /= 2) {
        const std::vector<vec3>& finer = levels.back();
        std::vector<vec3> level(std::size_t(6 * edge * edge));
        for (int face = 0; face < 6; face++)
            for (int y = 0; y < edge; y++)
                for (int x = 0; x < edge; x++) {
                    const vec3* f = &finer[std::size_t(face * 4 * edge * edge)];
                    int row = 2 * edge;
                    const vec3* corner = &f[2 * y * row + 2 * x];
                    level[std::size_t((face * edge + y) * edge + x)] = 0.25f * (corner[0] + corner[1] + corner[row] + corner[row + 1]);
                }
        levels.push_back(std::move(level));
    }
    const int mips = mipCount(probe.size);
    for (int mip = 1; mip < mips; mip++) {
        int edge = probe.size >> mip;
        float roughness = reflectionRoughness(float(mip), float(mips));
        std::vector<vec3> out(std::size_t(6 * edge * edge));
        parallelFor(std::size_t(6 * edge), context.threads, [&](std::size_t row) {
            int face = int(row) / edge, y = int(row) % edge;
            for (int x = 0; x < edge; x++) {
                vec3 normal = normalize(cubeDirection(face, (vec2(float(x), float(y)) + 0.5f) / float(edge)));
                out[row * std::size_t(edge) + std::size_t(x)] = prefiltered(levels, probe.size, normal, roughness);
            }
            context.progress.advance(1);
        });
        probe.mips.push_back(std::move(out));
    }
}

namespace
{
// A row of texels of a probe's faces.
struct ProbeRow {
    const ReflectionProbe& probe;
    uint number; // of the probe
    int row;     // of all faces, from the first one's top
};
}

// By paths. Returns sums over the texels: of the square of what either half of their paths is off by, and of the mean of the channels.
static dvec2 traceRow(const BakeContext& context, const ProbeRow& of, int samples, std::span<vec3> texels, RayCount& rays)
{
    const Tracer tracer{&context.transport, &context.transport.lights, &rays}, camera{&context.transport, &context.transport.none, &rays};
    const int size = of.probe.size, face = of.row / size, y = of.row % size;
    dvec2 sums(0.0);
    for (int x = 0; x < size; x++) {
        dvec3 half[2] = {dvec3(0.0), dvec3(0.0)};
        for (int s = 0; s < samples; s++) {
            Sampler random =
                makeSampler(hash3(context.seed + 0x7ef1ecu, of.number * 2u + uint(s & 1), uint(of.row) * 4096u + uint(x)), uint(s / 2));
            const vec2 uv = (vec2(float(x), float(y)) + next2(random)) / float(size);
            const Ray ray{of.probe.position, normalize(cubeDirection(face, uv)), kRayFar};
            const vec3 value = radianceSeen(camera, tracer, ray, random);
            if (isFinite(value))
                half[s & 1] += dvec3(value);
            else
                rays.notFinite++;
        }
        const dvec3 mean = (half[0] + half[1]) / double(samples), difference = (half[0] - half[1]) / double(samples);
        texels[std::size_t(x)] = vec3(mean);
        sums += dvec2(dot(difference, difference) / 3.0, (mean.x + mean.y + mean.z) / 3.0);
    }
    return sums;
}

// All rows of a probe; returns the same sums over them.
static dvec2 traceProbe(BakeContext& context, ReflectionProbe& probe, uint number, int samples)
{
    const std::size_t size = std::size_t(probe.size), rows = 6 * size;
    probe.mips.assign(1, std::vector<vec3>(rows * size));
    std::vector<dvec2> sums(rows, dvec2(0.0));
    parallelFor(rows, context.threads, [&](std::size_t row) {
        const std::span texels = std::span(probe.mips[0]).subspan(row * size, size);
        const Unit unit{Job::reflections, number, std::uint32_t(row)};
        doUnit(context, unit, {bytesOf(texels), bytesOf(std::span(&sums[row], 1))}, 1, [&](RayCount& rays) {
            sums[row] = traceRow(context, {probe, number, int(row)}, samples, texels, rays);
        });
    });
    dvec2 all(0.0);
    for (dvec2 sum : sums) all += sum;
    return all;
}

float bakeReflections(BakeContext& context, std::vector<ReflectionProbe>& probes, int size, int samples)
{
    dvec2 sums(0.0); // squares, light
    context.progress.begin("reflections", probes.size() * 6 * std::size_t(size), "rows");
    for (std::size_t p = 0; p < probes.size(); p++) {
        probes[p].size = size;
        sums += traceProbe(context, probes[p], uint(p), samples);
    }
    context.progress.end();
    std::size_t rows = 0; // of a face, all mips but the first
    for (int mip = 1; mip < mipCount(size); mip++) rows += std::size_t(size >> mip);
    context.progress.begin("prefilter", probes.size() * 6 * rows, "rows");
    for (ReflectionProbe& probe : probes) prefilter(context, probe);
    context.progress.end();
    const double texels = double(probes.size()) * 6.0 * size * size;
    return sums.y > 0.0 ? float(std::sqrt(sums.x / texels) / (sums.y / texels)) : 0.0f;
}
}
