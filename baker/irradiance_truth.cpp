// The truth of `afterglow probe --truth`: path-traced irradiance at points, with its standard error.
#include "baker/baker.hpp"
#include "baker/irradiance.hpp"
#include "engine/core/interrupt.hpp"
#include "engine/core/jobs.hpp"
#include "engine/scene/origin.hpp"

namespace afterglow
{
static constexpr int kTold = 1024; // paths of a point between two words about it

// Irradiance about one normal, with the standard error of its mean.
static void irradianceAbout(Tracer tracer, vec3 position, vec3 normal, int samples, uint seed, Progress& progress, vec3& value, vec3& error)
{
    Surface white = whiteSurface(position, normal, normal);
    dvec3 sum(0.0), squares(0.0);
    for (int i = 0; i < samples; i++) {
        stopIfInterrupted();
        if (i % kTold == 0) progress.advance(std::uint64_t(min(kTold, samples - i)));
        Sampler random = makeSampler(seed, uint(i));
        Ray ray = cosineRay(white, next2(random));
        dvec3 sample(irradianceSample(tracer, tracer, white, ray, closestHit(tracer, ray), random));
        if (!isFinite(vec3(sample))) continue;
        sum += sample;
        squares += sample * sample;
    }
    dvec3 mean = sum / double(samples);
    dvec3 variance = max(squares / double(samples) - mean * mean, dvec3(0.0));
    value = vec3(mean) * kPi;
    error = vec3(sqrt(variance / double(max(samples - 1, 1)))) * kPi;
}

std::vector<PointIrradiance> probeTruth(const Scene& scene, const std::vector<ProbePoint>& points, int samples, std::uint32_t seed,
                                        int threads, Progress& progress)
{
    static const vec3 kAxes[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    World world(scene, Content::everything);
    LightTransport transport(world, scene.lights);
    std::vector<PointIrradiance> out(points.size());
    std::uint64_t normals = 0;
    for (const ProbePoint& point : points) normals += point.normal ? 1 : 6;
    progress.begin("truth", normals * std::uint64_t(samples), "paths");
    parallelFor(points.size(), threads, [&](std::size_t i) {
        RayCount rays;
        Tracer tracer{&transport, &transport.lights, &rays};
        const ProbePoint& point = points[i];
        for (uint side = 0; side < (point.normal ? 1u : 6u); side++) {
            vec3 normal = point.normal ? normalize(*point.normal) : kAxes[side];
            irradianceAbout(tracer, fromLevel(point.position, scene.origin), normal, samples, hash2(uint(i) * 6u + side, seed), progress,
                            out[i].value[side], out[i].error[side]);
        }
    });
    progress.end();
    return out;
}
}
