#include "baker/lightmap_trace.hpp"
#include "baker/reach.hpp"
#include "engine/core/jobs.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace afterglow
{
Bed::Bed(const World& world, const std::vector<LightmapPlace>& where, const std::vector<ivec2>& sizes)
    : places(where), pageSizes(sizes), triangles(binTriangles(world, where, sizes))
{
    for (uint p = 0; p < triangles.size(); p++)
        for (int y = 0; y < triangles[p].tiles.y; y++)
            for (int x = 0; x < triangles[p].tiles.x; x++)
                if (!triangles[p].byTile[std::size_t(y * triangles[p].tiles.x + x)].empty()) tiles.push_back({p, ivec2(x, y)});
}

TilePoints Bed::pointsOf(const BakeContext& context, Tile& tile) const
{
    const World& world = context.transport.world;
    TilePoints points = rasteriseTile(world, places, pageSizes[tile.page], triangles[tile.page], tile.at);
    if (!tile.open) tile.open = openPoints(world, context.solids, points);
    leaveOutOthers(*tile.open, points);
    return points;
}

static constexpr int kMostAtOnce = 1 << 14; // samples of a tile: seconds of one thread, which a killed bake loses

std::uint64_t pathsOf(const std::vector<int>& samples)
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

void learn(const Tile& tile, const std::vector<TexelLight>& light, LightCache& cache)
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

static constexpr std::size_t kOneOf = 16;

// A sixteenth of the tiles, whose rays tell what such paths cost beside those that look light up.
static void traceFirst(BakeContext& context, const Bed& bed, std::vector<Tile>& tiles, const std::vector<int>& samples)
{
    std::vector<int> few(samples.size(), 0);
    for (std::size_t k = 0; k < (few.size() + kOneOf - 1) / kOneOf; k++) {
        const std::size_t i = scattered(k, few.size());
        few[i] = samples[i];
    }
    const RayCount before = context.rays();
    trace(context, bed, tiles, few);
    const RayCount after = context.rays();
    const double paths = double(after.closestPacked - before.closestPacked),
                 following = double(after.closest - before.closest + after.shadow - before.shadow);
    if (paths > 0.0)
        context.progress.costlyFirst(pathsOf(samples), pilotCost(following / paths, *std::max_element(samples.begin(), samples.end())));
}

void traceAndLearn(BakeContext& context, const Bed& bed, std::vector<Tile>& tiles, const std::vector<int>& samples)
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

std::vector<int> firstSamples(const Bed& bed, const LightmapEffort& effort)
{
    return std::vector<int>(bed.tiles.size(), effort.targetError ? kPilotSamples : effort.samples);
}

std::vector<int> pilotSamples(const BakeContext& context, const Bed& bed, const LightmapEffort& effort)
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

std::vector<Tile> traced(BakeContext& context, const Bed& bed, const LightmapEffort& effort, const Expect& expect)
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
}
