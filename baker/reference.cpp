// The truth: path-traced pictures and irradiance with no shortcut, to hold every approximation against.
#include "baker/baker.hpp"
#include "baker/irradiance.hpp"
#include "engine/core/interrupt.hpp"
#include "engine/core/jobs.hpp"
#include "engine/scene/origin.hpp"
#include "engine/scene/picture.hpp"

namespace shared
{
struct PortalSet {
    const afterglow::World& world;
    const afterglow::PortalTable& table;
};
FN int portalMet(PortalSet portals, Hit hit) { return portals.table.ofInstance[portals.world.triangles()[hit.triangle].instance]; }
FN const Portal& portalAt(PortalSet portals, uint i) { return portals.table.portals[i]; }
}

#include "shaders/portals.h"

namespace afterglow
{
static constexpr int kTile = 16;   // pixels
static constexpr int kTold = 1024; // paths of a point between two words about it

// Cosine-weighted visibility of the first surface within a range; 1 where the camera meets nothing.
static vec3 ambientVisibility(Tracer tracer, const Ray& seen, const Hit& hit, float range, Sampler& random)
{
    if (!(hit.distance < kRayFar)) return vec3(1.0f);
    Surface surface = surfaceAt(tracer, seen, hit);
    Ray ray = cosineRay(whiteSurface(surface.position, surface.frame.normal, surface.geometricNormal), next2(random));
    ray.far = range;
    return dot(ray.direction, surface.geometricNormal) > 0.0f ? unshadowed(tracer, ray, vec3(1.0f)) : vec3(0.0f);
}

Image truth(const Scene& scene, const TruthOptions& options, Progress& progress)
{
    const PortalTable portals = portalTable(scene);
    const Picture picture = pictureOf(options.camera, uvec2(options.size), options.seed, uint(options.portalDepth));
    World world(scene, Content::everything);
    LightTransport transport(world, scene.lights);
    transport.limits.maxBounces = uint(options.bounces);
    transport.limits.rouletteFrom = uint(options.rouletteFrom);
    if (options.scatterings) transport.limits.maxCollisions = uint(*options.scatterings);
    if (options.directOnly) transport.limits.maxVertices = 0;
    Image image(options.size.x, options.size.y, 3);
    ivec2 tiles = (options.size + kTile - 1) / kTile;
    progress.begin("truth", std::uint64_t(tiles.x) * std::uint64_t(tiles.y), "tiles");
    parallelFor(std::size_t(tiles.x) * std::size_t(tiles.y), options.threads, [&](std::size_t tile) {
        std::uint64_t rays = 0;
        Wavelengths at;            // of a path, where it is spectral
        std::vector<Light> lights; // as it meets them
        Tracer tracer{&transport, &transport.lights, &rays}, camera{&transport, &transport.none, &rays};
        if (options.spectral) tracer.lights = &lights, tracer.at = camera.at = &at;
        ivec2 corner = ivec2(int(tile) % tiles.x, int(tile) / tiles.x) * kTile;
        for (int y = corner.y; y < min(corner.y + kTile, options.size.y); y++)
            for (int x = corner.x; x < min(corner.x + kTile, options.size.x); x++) {
                const uvec2 pixel(x, y);
                const float first = hashFloat(hash3(pixel.x, pixel.y, picture.seed)); // of this pixel's wavelengths
                // What came in, and what white light would have brought, so that grey is grey however few the paths are. Of colours this
                // quotient is off by 3e-3 of white with two paths, 3e-4 with four, 2e-5 with eight.
                dvec3 sum(0.0), white(0.0);
                for (int i = 0; i < options.samples; i++) {
                    stopIfInterrupted();
                    Sampler random = pixelSampler(picture, pixel, uint(i));
                    if (options.spectral) {
                        at = drawWavelengths((first + float(i)) / float(options.samples));
                        at.lightsOf(scene, lights);
                        white += dvec3(whiteSeen(at));
                    }
                    Ray ray = pixelRay(picture, pixel, next2(random));
                    const Hit hit = hitThroughPortals(tracer, {world, portals}, ray, picture.portalDepth);
                    vec3 value = options.ao ? ambientVisibility(tracer, ray, hit, options.aoRange, random)
                                            : radianceAlong(camera, tracer, ray, hit, 0.0f, random);
                    if (options.spectral) value = at.seen * value;
                    if (isFinite(value)) sum += dvec3(value);
                }
                vec3 mean(sum / (options.spectral ? white : dvec3(options.samples)));
                for (int c = 0; c < 3; c++) image.at(x, y)[c] = mean[c];
            }
        progress.advance(1);
    });
    progress.end();
    return image;
}

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
        std::uint64_t rays = 0;
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
