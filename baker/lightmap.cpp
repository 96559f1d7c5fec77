#include "baker/lightmap.hpp"
#include "baker/lightmap_trace.hpp"
#include "shaders/lightmap.h"
#include <algorithm>
#include <cmath>

namespace afterglow
{
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
