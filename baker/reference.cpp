// The truth: path-traced pictures with no shortcut, to hold every approximation against.
#include <fmt/format.h> // first: it has a member called `check`, as error.hpp has a macro

#include "baker/baker.hpp"
#include "baker/irradiance.hpp"
#include "baker/waves.hpp"
#include "engine/core/error.hpp"
#include "engine/core/interrupt.hpp"
#include "engine/core/jobs.hpp"
#include "engine/core/log.hpp"
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
static constexpr int kTile = 16;         // pixels
static constexpr double kToldCut = 1e-3; // share of the paths that the cap of bounces ends: fewer are lost in the noise
static constexpr int kTogether = 16;     // paths of a pixel that a wave follows at once: with 1 or 4 a tile is slower by up to a tenth

// Cosine-weighted visibility of the first surface within a range; 1 where the camera meets nothing.
static vec3 ambientVisibility(Tracer tracer, const Ray& seen, const Hit& hit, float range, Sampler& random)
{
    if (!(hit.distance < kRayFar)) return vec3(1.0f);
    Surface surface = surfaceAt(tracer, seen, hit);
    Ray ray = cosineRay(whiteSurface(surface.position, surface.frame.normal, surface.geometricNormal, surface.meetingError), next2(random));
    ray.far = range;
    return dot(ray.direction, surface.geometricNormal) > 0.0f ? unshadowed(tracer, ray, vec3(1.0f)) : vec3(0.0f);
}

namespace
{
// A picture that is being traced, the same for all threads.
struct Shot {
    const TruthOptions& options;
    Picture picture;
    PortalTable portals;
    World world;
    LightTransport transport;
    mutable std::atomic<std::uint64_t> cut{0}; // paths, by the cap of bounces

    Shot(const Scene& scene, const TruthOptions& o)
        : options(o), picture(pictureOf(o.camera, uvec2(o.size), o.seed, uint(o.portalDepth))), portals(portalTable(scene)),
          world(scene, Content::everything), transport(world, scene.lights)
    {
        transport.limits.maxBounces = uint(o.bounces);
        transport.limits.rouletteFrom = uint(o.rouletteFrom);
        if (o.scatterings) transport.limits.maxCollisions = uint(*o.scatterings);
        if (o.directOnly) transport.limits.maxVertices = 0;
    }
};

// What came in at a pixel, and what white light would have brought, so that grey is grey however few the paths are. Of colours this
// quotient is off by 5e-3 of white with two paths, 4e-4 with four, 2e-5 with eight (wavelengths_test.cpp).
struct PixelSum {
    dvec3 value{0.0}, white{0.0};
    void add(vec3 sample)
    {
        if (isFinite(sample)) value += dvec3(sample);
    }
};
}

// One path after the other.
static PixelSum tracePixel(const Shot& shot, uvec2 pixel)
{
    const TruthOptions& options = shot.options;
    const LightTransport& transport = shot.transport;
    RayCount rays;
    Wavelengths at;            // of a path, where it is spectral
    std::vector<Light> lights; // as it meets them
    Tracer tracer{&transport, &transport.lights, &rays}, camera{&transport, &transport.none, &rays};
    if (options.spectral) tracer.lights = &lights, tracer.at = camera.at = &at;
    const float first = hashFloat(hash3(pixel.x, pixel.y, shot.picture.seed)); // of this pixel's wavelengths
    PixelSum sum;
    for (int i = 0; i < options.samples; i++) {
        stopIfInterrupted();
        Sampler random = pixelSampler(shot.picture, pixel, uint(i));
        if (options.spectral) {
            at = drawWavelengths((first + float(i)) / float(options.samples));
            at.lightsOf(shot.world.scene(), lights);
            sum.white += dvec3(whiteSeen(at));
        }
        Ray ray = pixelRay(shot.picture, pixel, next2(random));
        const Hit hit = hitThroughPortals(tracer, {shot.world, shot.portals}, ray, shot.picture.portalDepth);
        const vec3 value = options.ao ? ambientVisibility(tracer, ray, hit, options.aoRange, random)
                                      : radianceAlong(camera, tracer, ray, hit, 0.0f, random);
        sum.add(options.spectral ? at.seen * value : value);
    }
    if (!options.spectral) sum.white = dvec3(options.samples);
    shot.cut += rays.cut;
    return sum;
}

// The paths of a tile's pixels together, kTogether of each at once: the same paths (waves.hpp).
static void traceTile(const Shot& shot, ivec2 corner, ivec2 end, std::vector<PixelSum>& sums, Wave& wave)
{
    const LightTransport& transport = shot.transport;
    RayCount rays;
    const Tracer tracer{&transport, &transport.lights, &rays}, camera{&transport, &transport.none, &rays};
    sums.clear();
    for (int begin = 0; begin < shot.options.samples; begin += kTogether) {
        wave.begin();
        const int last = min(begin + kTogether, shot.options.samples);
        for (int y = corner.y; y < end.y; y++)
            for (int x = corner.x; x < end.x; x++)
                for (int i = begin; i < last; i++) {
                    Sampler random = pixelSampler(shot.picture, uvec2(x, y), uint(i));
                    Ray ray = pixelRay(shot.picture, uvec2(x, y), next2(random));
                    Hit hit = unknownHit();
                    if (!shot.portals.portals.empty())
                        hit = hitThroughPortals(tracer, {shot.world, shot.portals}, ray, shot.picture.portalDepth);
                    wave.add(beginPath(ray, 0.0f, random), hit);
                }
        followAll(camera, tracer, wave);
        const std::size_t each = std::size_t(last - begin);
        sums.resize(wave.paths.size() / each);
        for (std::size_t p = 0; p < wave.paths.size(); p++) sums[p / each].add(wave.paths[p].radiance);
    }
    for (PixelSum& sum : sums) sum.white = dvec3(shot.options.samples);
    shot.cut += rays.cut;
}

// What a cap hides is not noise: nothing in the picture shows it.
static void tellOfCut(const Shot& shot)
{
    const TruthOptions& options = shot.options;
    const double share = double(shot.cut) / (double(options.size.x) * double(options.size.y) * double(options.samples));
    if (share > kToldCut)
        note(fmt::format("{:.2g} % of the paths are cut at surface {}: the light that they still carry is missing; more --bounces find it",
                         100.0 * share, options.bounces + 2));
}

Image truth(const Scene& scene, const TruthOptions& options, Progress& progress)
{
    check(options.organisation == Organisation::loop || (!options.spectral && !options.ao), "a wave follows paths of three channels");
    const Shot shot(scene, options);
    Image image(options.size.x, options.size.y, 3);
    ivec2 tiles = (options.size + kTile - 1) / kTile;
    progress.begin("truth", std::uint64_t(tiles.x) * std::uint64_t(tiles.y), "tiles");
    parallelFor(std::size_t(tiles.x) * std::size_t(tiles.y), options.threads, [&](std::size_t tile) {
        const ivec2 corner = ivec2(int(tile) % tiles.x, int(tile) / tiles.x) * kTile, end = min(corner + kTile, options.size);
        std::vector<PixelSum> sums;
        Wave wave;
        if (options.organisation == Organisation::wavefront) traceTile(shot, corner, end, sums, wave);
        for (int y = corner.y, i = 0; y < end.y; y++)
            for (int x = corner.x; x < end.x; x++, i++) {
                const PixelSum sum = sums.empty() ? tracePixel(shot, uvec2(x, y)) : sums[std::size_t(i)];
                const vec3 mean(sum.value / sum.white);
                for (int c = 0; c < 3; c++) image.at(x, y)[c] = mean[c];
            }
        progress.advance(1);
    });
    progress.end();
    tellOfCut(shot);
    return image;
}
}
