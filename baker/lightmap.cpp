#include "baker/lightmap.hpp"
#include "baker/light_layers.hpp"
#include "baker/reach.hpp"
#include "engine/core/jobs.hpp"
#include "shaders/lightmap.h"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace afterglow
{
namespace
{
// The pages on their way.
struct Bed {
    const std::vector<LightmapPlace>& places;
    const std::vector<ivec2>& pageSizes;
    std::vector<PageTriangles> triangles; // of each page
    std::vector<Tile> tiles;              // without light

    Tile tileOf(std::size_t number, std::uint64_t layer) const { return {tiles[number].page, tiles[number].at, layer}; }

    // Of the tile's texels, without those that lie in solids: rays tell, once.
    TilePoints pointsOf(const BakeContext& context, Tile& tile) const
    {
        const World& world = context.transport.world;
        TilePoints points = rasteriseTile(world, places, pageSizes[tile.page], triangles[tile.page], tile.at);
        if (!tile.open) tile.open = openPoints(world, context.solids, points);
        leaveOutOthers(*tile.open, points);
        return points;
    }

    Bed(const World& world, const std::vector<LightmapPlace>& where, const std::vector<ivec2>& sizes)
        : places(where), pageSizes(sizes), triangles(binTriangles(world, where, sizes))
    {
        for (uint p = 0; p < triangles.size(); p++)
            for (int y = 0; y < triangles[p].tiles.y; y++)
                for (int x = 0; x < triangles[p].tiles.x; x++)
                    if (!triangles[p].byTile[std::size_t(y * triangles[p].tiles.x + x)].empty()) tiles.push_back({p, ivec2(x, y)});
    }
};
}

static constexpr int kMostAtOnce = 1 << 14; // samples of a tile: seconds of one thread, which a killed bake loses

// Paths of all tiles that have so many samples.
static std::uint64_t pathsOf(const std::vector<int>& samples)
{
    return std::accumulate(samples.begin(), samples.end(), std::uint64_t(0)) * kTileTexels;
}

// The error goes as paths^-fall after the pilot: randomised points that go where the noise is do better than 1/2. Measured on Cornell's
// box, to an error of 0.04.
static constexpr double kErrorFall = 0.7;

// Visits every index once, neighbours at far times: what has been done is of all sorts, and tells how long the rest takes.
static std::size_t scattered(std::size_t i, std::size_t count)
{
    auto stride = std::size_t(0.618 * double(count)) | 1u;
    while (std::gcd(stride, count) != 1) stride += 2;
    return i * stride % count;
}

static void learn(const Tile& tile, const std::vector<TexelLight>& light, LightCache& cache)
{
    for (int t = 0; t < kTileTexels; t++)
        cache.keep(tile.page, tile.at * kTileEdge + ivec2(t % kTileEdge, t / kTileEdge), light[std::size_t(t)]);
}

// Brings every tile to its number of samples; `cache` keeps what their texels have then, if there is one.
static void trace(BakeContext& context, const Bed& bed, std::vector<Tile>& tiles, const std::vector<int>& samples,
                  LightCache* cache = nullptr)
{
    parallelFor(tiles.size(), context.threads, [&](std::size_t k) {
        const std::size_t i = scattered(k, tiles.size());
        Tile& tile = tiles[i];
        if (tile.noise.samples >= samples[i] && !cache) return;
        if (tile.layer != context.layer.number) tile = bed.tileOf(i, context.layer.number); // paths of two levels are not mixed
        std::vector<TexelLight> light = takeLight(context, i, tile);
        TilePoints points;
        const uint seed = hash3(context.seed, tile.page, uint(tile.at.y) * 65536u + uint(tile.at.x));
        const auto unit = [&](int count) { return unitOf(i, count, context.layer.number); };
        while (tile.noise.samples < samples[i]) {
            const int first = tile.noise.samples; // few to begin with, which tell a later bake whether the tile serves
            const int last = std::min(samples[i], first == 0 && context.layer.asksForMoves() ? kPilotSamples : first + kMostAtOnce);
            doUnit(context, unit(last), {bytesOf(std::span(light))}, std::uint64_t(last - first) * kTileTexels, [&](RayCount& rays) {
                if (points.empty()) points = bed.pointsOf(context, tile);
                sampleTile(context, points, seed, first, last, light, rays);
            });
            if (context.journal) context.journal->forget(unit(first));
            tile.noise.samples = last;
        }
        if (cache) learn(tile, light, *cache);
        giveLight(context, tile, std::move(light));
    });
}

// A sixteenth of the tiles, whose rays tell what such paths cost beside those that look light up.
static void traceFirst(BakeContext& context, const Bed& bed, std::vector<Tile>& tiles, const std::vector<int>& samples)
{
    std::vector<int> few(samples);
    for (std::size_t i = 0; i < few.size(); i++)
        if (i % 16 != 0) few[i] = 0;
    const RayCount before = context.rays();
    trace(context, bed, tiles, few);
    const RayCount after = context.rays();
    const double paths = double(after.closestPacked - before.closestPacked),
                 following = double(after.closest - before.closest + after.shadow - before.shadow);
    if (paths > 0.0)
        context.progress.costlyFirst(pathsOf(samples), pilotCost(following / paths, *std::max_element(samples.begin(), samples.end())));
}

// The same; and from then on, paths look up what is known.
static void traceAndLearn(BakeContext& context, const Bed& bed, std::vector<Tile>& tiles, const std::vector<int>& samples)
{
    if (!context.caches) return trace(context, bed, tiles, samples);
    auto cache = std::make_shared<LightCache>(bed.places, bed.pageSizes, context.directional);
    context.tells = true;
    if (!context.cache) traceFirst(context, bed, tiles, samples);
    trace(context, bed, tiles, samples, cache.get());
    context.tells = false;
    cache->settle(sightIn(context.transport.world), context.threads);
    context.cache = std::move(cache);
}

// A tile's texels into their page.
static void write(const Tile& tile, const std::vector<TexelLight>& all, Lightmap& page, TexelGuides& guides)
{
    for (int t = 0; t < kTileTexels; t++) {
        const ivec2 at = tile.at * kTileEdge + ivec2(t % kTileEdge, t / kTileEdge);
        const TexelLight& light = all[std::size_t(t)];
        if (at.x >= page.width || at.y >= page.height || !light.valid()) continue;
        const std::size_t texel = std::size_t(at.y) * std::size_t(page.width) + std::size_t(at.x);
        page.texels[texel] = vec3(light.mean());
        page.valid[texel] = 1;
        if (!page.direction.empty()) page.direction[texel] = light.direction();
        guides.position[texel] = vec3(light.position / double(light.points));
        guides.normal[texel] = light.ownNormal();
        guides.half[texel] = vec3(light.halfDifference());
        guides.variance[texel] = float(tile.share * light.variance() / std::max(light.count[0] + light.count[1] - 1, 1));
    }
}

// What is traced first.
static std::vector<int> firstSamples(const Bed& bed, const LightmapEffort& effort)
{
    return std::vector<int>(bed.tiles.size(), effort.targetError ? kPilotSamples : effort.samples);
}

// What of them fills the cache.
static std::vector<int> pilotSamples(const BakeContext& context, const Bed& bed, const LightmapEffort& effort)
{
    if (!context.caches) return {};
    return std::vector<int>(bed.tiles.size(), effort.targetError ? kPilotSamples : pilotOf(effort.samples));
}

// Of all tiles, and what an earlier bake left of them is taken over; returns what each is to be brought to, at least what it has.
static std::vector<int> beginTiles(BakeContext& context, const Bed& bed, const LightmapEffort& effort, std::vector<Tile>& tiles)
{
    for (std::size_t i = 0; i < bed.tiles.size(); i++) tiles.push_back(bed.tileOf(i, context.layer.number));
    std::vector<int> first = firstSamples(bed, effort);
    const Former former = formerOf(context, tiles.size());
    if (former.layer == 0) return first;
    if (former.layer != context.layer.number) trace(context, bed, tiles, std::vector(tiles.size(), std::min(first[0], kPilotSamples)));
    takeOver(context, former, tiles);
    for (std::size_t i = 0; i < first.size(); i++) first[i] = std::max(first[i], tiles[i].noise.samples);
    return first;
}

// Is told how many paths a layer takes in all, as far as that is known.
using Expect = std::function<void(std::uint64_t paths)>;

// Round by round, `samples` in the first one, until the tiles are off by no more than `target`; returns what each has then.
static std::vector<int> traceToError(BakeContext& context, const Bed& bed, std::vector<Tile>& tiles, std::vector<int> samples,
                                     double target, const Expect& expect)
{
    traceAndLearn(context, bed, tiles, samples);
    Aim aim = aimOf(context, tiles, target);
    double fall = kErrorFall;
    while (aim.error > aim.target) {
        std::vector<TileNoise> noise;
        for (const Tile& tile : tiles) noise.push_back(aim.stays(tile) ? TileNoise{0, 0.0, tile.noise.samples} : tile.noise);
        const double paths = double(pathsOf(samples)), before = aim.error / aim.target;
        samples = nextSamples(noise, aim.error, aim.target);
        for (std::size_t i = 0; i < samples.size(); i++) samples[i] = aim.stays(tiles[i]) ? tiles[i].noise.samples : samples[i];
        expect(std::max(pathsOf(samples), std::uint64_t(paths * std::pow(before, 1.0 / fall))));
        const bool grows =
            !std::equal(samples.begin(), samples.end(), noise.begin(), [](int n, const TileNoise& t) { return n == t.samples; });
        if (!grows) break; // every tile has the most that there are
        traceAndLearn(context, bed, tiles, samples);
        aim = aimOf(context, tiles, target);
        fall = std::clamp(std::log(before * aim.target / aim.error) / std::log(double(pathsOf(samples)) / paths), 0.5, 1.0);
    }
    return samples;
}

// All tiles by one layer of light.
static std::vector<Tile> traced(BakeContext& context, const Bed& bed, const LightmapEffort& effort, const Expect& expect)
{
    std::vector<Tile> tiles;
    std::vector<int> samples = beginTiles(context, bed, effort, tiles);
    if (effort.targetError) {
        samples = traceToError(context, bed, tiles, std::move(samples), double(*effort.targetError), expect);
    } else {
        if (const std::vector<int> pilot = pilotSamples(context, bed, effort); pathsOf(pilot) > 0)
            traceAndLearn(context, bed, tiles, pilot);
        trace(context, bed, tiles, samples);
    }
    expect(pathsOf(samples));
    leave(context, tiles);
    return tiles;
}

namespace
{
struct TracedLayer {
    std::vector<Tile> tiles;
    vec3 strength;
};
}

// The light of a tile from all layers, which `sum` is told the measures of.
static std::vector<TexelLight> summed(const BakeContext& context, std::vector<TracedLayer>& layers, std::size_t i, Tile& sum)
{
    std::vector<TexelLight> light;
    for (TracedLayer& layer : layers) {
        std::vector<TexelLight> own = takeLight(context, i, layer.tiles[i]);
        const dvec3 strength(layer.strength);
        sum.told += strength * strength * layer.tiles[i].told;
        if (layers.size() == 1 && strength == dvec3(1.0)) {
            light = std::move(own);
            break;
        }
        light.resize(own.size());
        for (std::size_t t = 0; t < own.size(); t++) light[t].add(own[t], layer.strength);
    }
    sum.noise.samples = layers.front().tiles[i].noise.samples;
    sum.measure(light);
    return light;
}

LightmapResult bakeLightmaps(BakeContext& context, const std::vector<LightmapPlace>& places, const std::vector<ivec2>& pageSizes,
                             const LightmapEffort& effort, const TakePage& take)
{
    Bed bed(context.transport.world, places, pageSizes);
    LightmapResult result;
    std::vector<TracedLayer> layers;
    const std::uint64_t each = layerCount(context);
    std::uint64_t done = 0; // paths of the layers so far
    context.progress.begin("lightmaps", each * pathsOf(firstSamples(bed, effort)), "paths");
    if (each == 1) context.progress.costlyFirst(pathsOf(pilotSamples(context, bed, effort)), kPilotCost);
    eachLayer(context, [&](BakeContext& layer, vec3 strength) {
        std::uint64_t paths = 0;
        layers.push_back({traced(layer, bed, effort,
                                 [&](std::uint64_t expected) {
                                     paths = expected;
                                     context.progress.expect(done + paths * (each - layers.size()));
                                 }),
                          strength});
        done += paths;
    });
    context.progress.end();

    const std::shared_ptr<LightCache> known =
        context.caches ? std::make_shared<LightCache>(places, pageSizes, context.directional) : nullptr;
    double paths = 0.0;
    std::uint64_t kept = 0; // texels, of each layer
    ErrorSum error;
    std::size_t t = 0;
    for (uint p = 0; p < pageSizes.size(); p++) {
        const ivec2 size = pageSizes[p];
        Lightmap page;
        page.width = size.x;
        page.height = size.y;
        page.texels.assign(std::size_t(size.x) * std::size_t(size.y), vec3(0.0f));
        page.valid.assign(page.texels.size(), 0);
        if (context.directional) page.direction.assign(page.texels.size(), directionUnbent());
        result.texels += page.texels.size();
        TexelGuides guides{std::vector<vec3>(page.texels.size()), std::vector<vec3>(page.texels.size()),
                           std::vector<vec3>(page.texels.size()), std::vector<float>(page.texels.size())};
        for (; t < bed.tiles.size() && bed.tiles[t].page == p; t++) {
            Tile& tile = bed.tiles[t];
            const std::vector<TexelLight> light = summed(context, layers, t, tile);
            write(tile, light, page, guides);
            if (known) learn(tile, light, *known);
            error.add(tile);
            result.validTexels += tile.noise.texels;
            for (const TracedLayer& layer : layers) {
                paths += double(tile.noise.texels) * layer.tiles[t].noise.samples;
                kept += layer.tiles[t].kept ? tile.noise.texels : 0;
            }
        }
        take(std::move(page), guides);
    }
    if (known) known->settle(sightIn(context.transport.world), context.threads);
    context.cache = known; // for later stages
    result.samples = result.validTexels > 0 ? paths / double(result.validTexels) : 0.0;
    result.kept = result.validTexels > 0 ? double(kept) / double(each * result.validTexels) : 0.0;
    result.estimatedError = float(error.relative());
    return result;
}

void learnLight(BakeContext& context, const std::vector<LightmapPlace>& places, const std::vector<ivec2>& pageSizes, int samples)
{
    if (pageSizes.empty()) return;
    const Bed bed(context.transport.world, places, pageSizes);
    std::vector<Tile> tiles;
    for (std::size_t i = 0; i < bed.tiles.size(); i++) tiles.push_back(bed.tileOf(i, context.layer.number));
    const std::vector<int> few(tiles.size(), pilotOf(samples)), all(tiles.size(), samples);
    context.progress.begin("light", pathsOf(all), "paths");
    context.progress.costlyFirst(pathsOf(few), kPilotCost);
    traceAndLearn(context, bed, tiles, few);
    traceAndLearn(context, bed, tiles, all);
    context.progress.end();
}
}
