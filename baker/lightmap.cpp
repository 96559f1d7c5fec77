#include "baker/lightmap.hpp"
#include "baker/rounds.hpp"
#include "baker/tile_light.hpp"
#include "engine/core/jobs.hpp"
#include "shaders/color.h"
#include "shaders/lightmap.h"
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace afterglow
{
namespace
{
// The unit of work.
struct Tile {
    uint page;
    ivec2 at;
    TileNoise noise;
    std::vector<TexelLight> light;     // empty: it has none, or it waits in the journal
    double squares = 0.0, total = 0.0; // of the half differences, and of the means, of its valid texels
    double share = 1.0;                // of the variance that independent paths would leave in a mean: theirs are spread evenly

    void measure(const std::vector<TexelLight>& of)
    {
        noise.texels = 0;
        noise.variance = squares = total = 0.0;
        double left = 0.0;
        for (const TexelLight& texel : of) {
            if (!texel.valid()) continue;
            const dvec3 mean = texel.mean(), difference = texel.halfDifference();
            noise.texels++;
            noise.variance += texel.variance();
            squares += dot(difference, difference) / 3.0;
            total += (mean.x + mean.y + mean.z) / 3.0;
            const double bright = double(luminance(vec3(difference)));
            left += bright * bright;
        }
        if (noise.variance > 0.0) share = std::min(left * double(noise.samples) / noise.variance, 1.0);
        if (noise.texels > 0) noise.variance /= double(noise.texels);
    }
};

// The pages on their way.
struct Bed {
    const std::vector<LightmapPlace>& places;
    const std::vector<ivec2>& pageSizes;
    std::vector<PageTriangles> triangles; // of each page
    std::vector<Tile> tiles;

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

static Unit unitOf(std::size_t tile, int samples) { return {Job::lightmaps, std::uint32_t(tile), std::uint32_t(samples)}; }

// The tile's light, out of where it waited.
static std::vector<TexelLight> takeLight(const BakeContext& context, std::size_t i, Tile& tile)
{
    if (!tile.light.empty()) return std::exchange(tile.light, {});
    std::vector<TexelLight> light(kTileTexels);
    if (tile.noise.samples > 0) readBack(context, unitOf(i, tile.noise.samples), {bytesOf(std::span(light))});
    return light;
}

// Brings every tile to its number of samples.
static void trace(BakeContext& context, Bed& bed, const std::vector<int>& samples)
{
    parallelFor(bed.tiles.size(), context.threads, [&](std::size_t k) {
        const std::size_t i = scattered(k, bed.tiles.size());
        Tile& tile = bed.tiles[i];
        if (tile.noise.samples >= samples[i]) return;
        std::vector<TexelLight> light = takeLight(context, i, tile);
        TilePoints points;
        const uint seed = hash3(context.seed, tile.page, uint(tile.at.y) * 65536u + uint(tile.at.x));
        while (tile.noise.samples < samples[i]) {
            const int first = tile.noise.samples, last = std::min(samples[i], first + kMostAtOnce);
            doUnit(context, unitOf(i, last), {bytesOf(std::span(light))}, std::uint64_t(last - first) * kTileTexels, [&](RayCount& rays) {
                if (points.empty()) {
                    const World& world = context.transport.world;
                    points = rasteriseTile(world, bed.places, bed.pageSizes[tile.page], bed.triangles[tile.page], tile.at);
                    leaveOutBuried(world, context.solids, points);
                }
                sampleTile(context, points, seed, first, last, light, rays);
            });
            if (context.journal) context.journal->forget(unitOf(i, first));
            tile.noise.samples = last;
        }
        tile.measure(light);
        if (!context.streamed) tile.light = std::move(light);
    });
}

// Relative RMSE of a texel. Summed in the tiles' order: the same bits for any number of threads.
static double measuredError(const Bed& bed)
{
    double squares = 0.0, total = 0.0, texels = 0.0;
    for (const Tile& tile : bed.tiles) {
        squares += tile.squares;
        total += tile.total;
        texels += double(tile.noise.texels);
    }
    return total > 0.0 ? std::sqrt(squares / texels) / (total / texels) : 0.0;
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
        guides.normal[texel] = safeNormalize(vec3(light.normal / double(light.points)), vec3(0.0f, 1.0f, 0.0f));
        guides.variance[texel] = float(tile.share * light.variance() / std::max(light.count[0] + light.count[1] - 1, 1));
    }
}

LightmapResult bakeLightmaps(BakeContext& context, const std::vector<LightmapPlace>& places, const std::vector<ivec2>& pageSizes,
                             const LightmapEffort& effort, const TakePage& take)
{
    Bed bed(context.transport.world, places, pageSizes);
    LightmapResult result;
    const double target = double(effort.targetError.value_or(0.0f));
    std::vector<int> next(bed.tiles.size(), effort.targetError ? kPilotSamples : effort.samples);
    context.progress.begin("lightmaps", pathsOf(next), "paths");
    trace(context, bed, next);
    double error = measuredError(bed);
    double fall = kErrorFall;
    while (effort.targetError && error > target) {
        std::vector<TileNoise> noise;
        for (const Tile& tile : bed.tiles) noise.push_back(tile.noise);
        const double paths = double(pathsOf(next)), before = error;
        next = nextSamples(noise, error, target);
        context.progress.expect(std::max(pathsOf(next), std::uint64_t(paths * std::pow(error / target, 1.0 / fall))));
        const bool grows = !std::equal(next.begin(), next.end(), noise.begin(), [](int n, const TileNoise& t) { return n == t.samples; });
        if (!grows) break; // every tile has the most that there are
        trace(context, bed, next);
        error = measuredError(bed);
        fall = std::clamp(std::log(before / error) / std::log(double(pathsOf(next)) / paths), 0.5, 1.0);
    }
    context.progress.expect(pathsOf(next));
    context.progress.end();

    double paths = 0.0;
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
                           std::vector<float>(page.texels.size())};
        for (; t < bed.tiles.size() && bed.tiles[t].page == p; t++) {
            Tile& tile = bed.tiles[t];
            write(tile, takeLight(context, t, tile), page, guides);
            result.validTexels += tile.noise.texels;
            paths += double(tile.noise.texels) * tile.noise.samples;
        }
        take(std::move(page), guides);
    }
    result.samples = result.validTexels > 0 ? paths / double(result.validTexels) : 0.0;
    result.estimatedError = float(error);
    return result;
}
}
