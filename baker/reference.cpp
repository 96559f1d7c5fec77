// The truth: path-traced pictures and irradiance with no shortcut, to hold every approximation against.
#include "baker/baker.hpp"
#include "baker/irradiance.hpp"
#include "engine/core/interrupt.hpp"
#include "engine/core/jobs.hpp"
#include "engine/scene/flats.hpp"
#include "engine/scene/origin.hpp"
#include "shaders/camera.h"
#include "shaders/frame.h"

namespace afterglow
{
static constexpr int kTile = 16;   // pixels
static constexpr int kTold = 1024; // paths of a point between two words about it

// Cosine-weighted visibility of the first surface within a range; 1 where the camera meets nothing.
static vec3 ambientVisibility(Tracer tracer, const Ray& seen, float range, Sampler& random)
{
    Hit hit = closestHit(tracer, seen);
    if (!(hit.distance < kRayFar)) return vec3(1.0f);
    Surface surface = surfaceAt(tracer, seen, hit);
    Ray ray = cosineRay(whiteSurface(surface.position, surface.frame.normal, surface.geometricNormal), next2(random));
    ray.far = range;
    return dot(ray.direction, surface.geometricNormal) > 0.0f ? transmittance(tracer, ray) : vec3(0.0f);
}

// Through a point of the picture, 0..1 from its upper left corner.
static Ray cameraRay(const Camera& camera, vec2 projectionDiagonal, vec2 uv)
{
    if (camera.fovY > 0.0f) {
        vec3 direction(camera.toWorld * vec4(viewDirection(uv, projectionDiagonal), 0.0f));
        return Ray{vec3(camera.toWorld[3]), normalize(direction), kRayFar};
    }
    vec4 from = camera.toWorld * vec4(uvToNdc(uv) / projectionDiagonal, 0.0f, 1.0f);
    return Ray{vec3(from), normalize(-vec3(camera.toWorld[2])), kRayFar};
}

// By instance: the portal that it is, null: none. Of an object of several materials only what is flat is one.
static std::vector<const Flat*> portalsOf(const Scene& scene, const Flats& flats)
{
    std::vector<const Flat*> portals(instances(scene).size(), nullptr);
    for (const Flat& flat : flats.portals)
        for (uint surface : flat.surfaces) portals[surface] = &flat;
    return portals;
}

// A camera's ray that meets the front of a portal goes on from its twin. Only cameras see through portals: light does not pass them, and
// what a medium before one takes of the view is not counted.
static Ray throughPortals(Tracer tracer, const std::vector<const Flat*>& portals, Ray ray, int depth)
{
    for (; depth > 0; --depth) {
        Hit hit = closestHit(tracer, ray);
        if (!(hit.distance < kRayFar)) break;
        const Flat* flat = portals[tracer.transport->world.triangles()[hit.triangle].instance];
        if (!flat || !(dot(flat->normal, dvec3(ray.direction)) < 0.0)) break;
        dvec3 met = dvec3(ray.origin) + double(hit.distance) * dvec3(ray.direction);
        vec3 from(flat->through * dvec4(met, 1.0)), direction(dmat3(flat->through) * dvec3(ray.direction));
        ray = Ray{offsetRay(from, vec3(flat->beyond)), normalize(direction), kRayFar};
    }
    return ray;
}

Image truth(const Scene& scene, const TruthOptions& options, Progress& progress)
{
    const Flats flats = findFlats(scene);
    const std::vector<const Flat*> portals = portalsOf(scene, flats);
    World world(scene, Content::everything);
    LightTransport transport(world, scene.lights);
    transport.limits.maxBounces = uint(options.bounces);
    if (options.scatterings) transport.limits.maxCollisions = uint(*options.scatterings);
    if (options.directOnly) transport.limits.maxVertices = 0;
    Image image(options.size.x, options.size.y, 3);
    mat4 lens = projection(options.camera, uvec2(options.size));
    vec2 diagonal(lens[0][0], lens[1][1]);
    ivec2 tiles = (options.size + kTile - 1) / kTile;
    progress.begin("truth", std::uint64_t(tiles.x) * std::uint64_t(tiles.y), "tiles");
    parallelFor(std::size_t(tiles.x) * std::size_t(tiles.y), options.threads, [&](std::size_t tile) {
        std::uint64_t rays = 0;
        Tracer tracer{&transport, &transport.lights, &rays}, camera{&transport, &transport.none, &rays};
        ivec2 corner = ivec2(int(tile) % tiles.x, int(tile) / tiles.x) * kTile;
        for (int y = corner.y; y < min(corner.y + kTile, options.size.y); y++)
            for (int x = corner.x; x < min(corner.x + kTile, options.size.x); x++) {
                dvec3 sum(0.0);
                for (int i = 0; i < options.samples; i++) {
                    stopIfInterrupted();
                    Sampler random = makeSampler(hash2(uint(y) * 65536u + uint(x), options.seed), uint(i));
                    vec2 jitter = next2(random);
                    Ray ray = cameraRay(options.camera, diagonal, (vec2(float(x), float(y)) + jitter) / vec2(options.size));
                    if (!flats.portals.empty()) ray = throughPortals(tracer, portals, ray, options.portalDepth);
                    vec3 value =
                        options.ao ? ambientVisibility(tracer, ray, options.aoRange, random) : radianceSeen(camera, tracer, ray, random);
                    if (isFinite(value)) sum += dvec3(value);
                }
                vec3 mean(sum / double(options.samples));
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
