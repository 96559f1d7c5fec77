// First bounces are traced transposed: one direction of the hemisphere for all texels of a tile at once, since rays that start close
// together and point alike travel through the tree as packets (2 to 4 times the rays per second). The scrambling of the directions differs
// from tile to tile; everything after the first hit is each texel's own.
#include "baker/lightmap.hpp"
#include "baker/irradiance.hpp"
#include "engine/core/interrupt.hpp"
#include "engine/core/jobs.hpp"
#include <cmath>
#include <optional>

namespace afterglow
{
static constexpr float kBuriedShare = 0.9f; // of first hits on backs: the point lies inside a solid

// Samples of one point of a texel, in two independent halves.
struct PointSum {
    dvec3 half[2] = {dvec3(0.0), dvec3(0.0)};
    double squares = 0.0; // of luminance
    int count[2] = {0, 0};
    int behind = 0, unseen = 0; // first hits on the backs of triangles, and of one-sided ones
    bool buried() const { return float(behind) > kBuriedShare * float(count[0] + count[1]); }
};

// A texel's points, added up: those that touch or lie within another solid (a floor under a wall) are left out where others see light.
struct TexelSum {
    dvec3 half[2] = {dvec3(0.0), dvec3(0.0)};
    double squares = 0.0;
    int count[2] = {0, 0};
    vec3 position{0.0f}, normal{0.0f}; // the mean of its points
};

static Surface whiteAt(const World& world, const TexelPoint& point)
{
    const World::Triangle& t = world.triangles()[point.triangle];
    const std::vector<Vertex>& v = world.vertices();
    const Vertex &v0 = v[t.vertex[0]], &v1 = v[t.vertex[1]], &v2 = v[t.vertex[2]];
    float b = point.barycentric.x, c = point.barycentric.y, a = 1.0f - b - c;
    vec3 geometric = normalize(cross(v1.position - v0.position, v2.position - v0.position));
    vec3 shading = safeNormalize(a * v0.normal + b * v1.normal + c * v2.normal, geometric);
    return whiteSurface(a * v0.position + b * v1.position + c * v2.position, dot(shading, geometric) < 0.0f ? geometric : shading,
                        geometric);
}

// One sample of every texel of the tile.
static void sampleTile(BakeContext& context, const std::vector<std::vector<TexelPoint>>& texels, uint tileSeed, int half, uint index,
                       std::vector<std::vector<PointSum>>& sums, std::uint64_t& rays)
{
    const World& world = context.transport.world;
    Tracer here{&context.transport, &context.direct, &rays};
    Tracer beyond{&context.transport, &context.transport.lights, &rays};
    Sampler shared = makeSampler(hash2(tileSeed, uint(half)), index);
    vec2 direction = next2(shared);

    Surface white[kPacket];
    Sampler random[kPacket];
    Ray packet[kPacket];
    Hit hits[kPacket];
    PointSum* owner[kPacket];
    int filled = 0;
    for (int texel = 0; texel <= kTileTexels; texel++) {
        if (texel < kTileTexels && !texels[std::size_t(texel)].empty()) {
            const auto& points = texels[std::size_t(texel)];
            random[filled] = makeSampler(hash3(tileSeed, uint(texel) + 1u, uint(half)), index);
            std::size_t pick = std::size_t(next1(random[filled]) * float(points.size()));
            white[filled] = whiteAt(world, points[pick]);
            packet[filled] = cosineRay(white[filled], direction);
            owner[filled++] = &sums[std::size_t(texel)][pick];
        }
        if (filled == 0 || (filled < kPacket && texel < kTileTexels)) continue;
        world.closestHits(packet, hits, filled);
        rays += std::uint64_t(filled);
        for (int i = 0; i < filled; i++) {
            vec3 value = irradianceSample(here, beyond, white[i], packet[i], hits[i], random[i]);
            if (!isFinite(value)) continue; // NaN or overflow: dropped, the mean is over what is finite
            PointSum& sum = *owner[i];
            sum.half[half] += dvec3(value);
            sum.count[half]++;
            sum.squares += double(luminance(value)) * double(luminance(value));
            if (!context.solids.meetsInside(packet[i], hits[i])) continue;
            sum.behind++;
            if ((world.materialOf(hits[i].triangle).flags & kMaterialDoubleSided) == 0) sum.unseen++;
        }
        filled = 0;
    }
}

// Adds the points of a texel up: those that see light, or all of them where none does. Nothing when the texel lies inside a solid whose
// inside nobody sees (its backs are one-sided): the dilation fills it.
static std::optional<TexelSum> addPoints(const World& world, const std::vector<TexelPoint>& points, const std::vector<PointSum>& sums)
{
    bool allBuried = true;
    int samples = 0, unseen = 0;
    for (const PointSum& sum : sums) {
        if (sum.count[0] + sum.count[1] == 0) continue;
        allBuried = allBuried && sum.buried();
        samples += sum.count[0] + sum.count[1];
        unseen += sum.unseen;
    }
    if (samples == 0 || float(unseen) > kBuriedShare * float(samples)) return std::nullopt;
    TexelSum texel;
    int lit = 0;
    for (std::size_t p = 0; p < points.size(); p++) {
        const PointSum& sum = sums[p];
        if (sum.count[0] + sum.count[1] == 0 || (sum.buried() && !allBuried)) continue;
        for (int half = 0; half < 2; half++) {
            texel.half[half] += sum.half[half];
            texel.count[half] += sum.count[half];
        }
        texel.squares += sum.squares;
        Surface white = whiteAt(world, points[p]);
        texel.position += white.position;
        texel.normal += white.frame.normal;
        lit++;
    }
    texel.position /= float(lit);
    texel.normal = safeNormalize(texel.normal, vec3(0.0f, 1.0f, 0.0f));
    return texel;
}

LightmapResult bakeLightmaps(BakeContext& context, const std::vector<LightmapPlace>& places, const std::vector<ivec2>& pageSizes,
                             int samples)
{
    std::vector<PageTriangles> pages = binTriangles(context.transport.world, places, pageSizes);
    struct Unit {
        uint page;
        ivec2 tile;
        double squares = 0.0, total = 0.0; // of the half difference, and of the mean
        std::uint64_t valid = 0;
    };
    std::vector<Unit> units;
    LightmapResult result;
    for (uint p = 0; p < pages.size(); p++) {
        Lightmap lightmap;
        lightmap.width = pageSizes[p].x;
        lightmap.height = pageSizes[p].y;
        lightmap.texels.assign(std::size_t(pageSizes[p].x) * std::size_t(pageSizes[p].y), vec3(0.0f));
        lightmap.valid.assign(lightmap.texels.size(), 0);
        result.texels += lightmap.texels.size();
        result.guides.push_back({std::vector<vec3>(lightmap.texels.size()), std::vector<vec3>(lightmap.texels.size()),
                                 std::vector<float>(lightmap.texels.size())});
        result.pages.push_back(std::move(lightmap));
        for (int y = 0; y < pages[p].tiles.y; y++)
            for (int x = 0; x < pages[p].tiles.x; x++)
                if (!pages[p].byTile[std::size_t(y * pages[p].tiles.x + x)].empty()) units.push_back(Unit{p, ivec2(x, y)});
    }

    context.progress.begin("lightmaps", units.size(), "tiles");
    parallelFor(units.size(), context.threads, [&](std::size_t i) {
        Unit& unit = units[i];
        std::uint64_t rays = 0;
        auto texels = rasteriseTile(context.transport.world, places, pageSizes[unit.page], pages[unit.page], unit.tile);
        uint seed = hash3(context.seed, unit.page, uint(unit.tile.y) * 65536u + uint(unit.tile.x));
        std::vector<std::vector<PointSum>> sums;
        for (const auto& points : texels) sums.emplace_back(points.size());
        for (int half = 0; half < 2; half++)
            for (int s = 0; s < (samples + 1 - half) / 2; s++) {
                stopIfInterrupted();
                sampleTile(context, texels, seed, half, uint(s), sums, rays);
            }

        Lightmap& page = result.pages[unit.page];
        for (int t = 0; t < kTileTexels; t++) {
            ivec2 at = unit.tile * kTileEdge + ivec2(t % kTileEdge, t / kTileEdge);
            if (at.x >= page.width || at.y >= page.height) continue;
            std::optional<TexelSum> added = addPoints(context.transport.world, texels[std::size_t(t)], sums[std::size_t(t)]);
            if (!added) continue;
            const TexelSum& sum = *added;
            int count = sum.count[0] + sum.count[1];
            std::size_t texel = std::size_t(at.y) * std::size_t(page.width) + std::size_t(at.x);
            dvec3 mean = (sum.half[0] + sum.half[1]) / double(count);
            page.texels[texel] = vec3(mean);
            page.valid[texel] = 1;
            TexelGuides& guides = result.guides[unit.page];
            guides.position[texel] = sum.position;
            guides.normal[texel] = sum.normal;
            double bright = double(luminance(vec3(mean)));
            guides.variance[texel] = float(std::max(sum.squares / count - bright * bright, 0.0) / std::max(count - 1, 1));
            unit.valid++;
            unit.total += (mean.x + mean.y + mean.z) / 3.0;
            if (sum.count[0] == 0 || sum.count[1] == 0) continue;
            dvec3 difference = 0.5 * (sum.half[0] / double(sum.count[0]) - sum.half[1] / double(sum.count[1]));
            unit.squares += dot(difference, difference) / 3.0;
        }
        context.rays += rays;
        context.progress.advance(1);
    });
    context.progress.end();

    double squares = 0.0, total = 0.0; // summed in unit order: the same bits for any number of threads
    for (const Unit& unit : units) {
        squares += unit.squares;
        total += unit.total;
        result.validTexels += unit.valid;
    }
    if (total > 0.0) result.estimatedError = float(std::sqrt(squares / double(result.validTexels)) / (total / double(result.validTexels)));
    return result;
}
}
