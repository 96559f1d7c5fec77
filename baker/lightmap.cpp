// First bounces are traced transposed: one direction of the hemisphere for all texels of a tile at once, since rays that start close
// together and point alike travel through the tree as packets (2 to 4 times the rays per second). The scrambling of the directions differs
// from tile to tile; everything after the first hit is each texel's own.
#include "baker/lightmap.hpp"
#include "baker/irradiance.hpp"
#include "engine/core/jobs.hpp"
#include <cmath>

namespace afterglow
{
static constexpr int kPacket = 16;           // rays
static constexpr float kInvalidShare = 0.5f; // of first hits on the back of one-sided surfaces: the texel lies inside a solid

struct TexelSum {
    dvec3 half[2] = {dvec3(0.0), dvec3(0.0)}; // sums of two independent halves of the samples
    double squares = 0.0;                     // of luminance
    vec3 position{0.0f}, normal{0.0f};
    int count[2] = {0, 0};
    int behind = 0; // first hits on backs
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
                       std::vector<TexelSum>& sums, std::uint64_t& rays)
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
    int owner[kPacket];
    int filled = 0;
    for (int texel = 0; texel <= kTileTexels; texel++) {
        if (texel < kTileTexels && !texels[std::size_t(texel)].empty()) {
            const auto& points = texels[std::size_t(texel)];
            random[filled] = makeSampler(hash3(tileSeed, uint(texel) + 1u, uint(half)), index);
            std::size_t pick = std::size_t(next1(random[filled]) * float(points.size()));
            white[filled] = whiteAt(world, points[pick]);
            packet[filled] = cosineRay(white[filled], direction);
            owner[filled++] = texel;
        }
        if (filled == 0 || (filled < kPacket && texel < kTileTexels)) continue;
        world.closestHits(packet, hits, filled);
        rays += std::uint64_t(filled);
        for (int i = 0; i < filled; i++) {
            TexelSum& sum = sums[std::size_t(owner[i])];
            vec3 value = irradianceSample(here, beyond, white[i], packet[i], hits[i], random[i]);
            if (!(dot(value, value) < kFloatMax)) continue; // NaN or overflow: dropped, the mean is over what is finite
            sum.half[half] += dvec3(value);
            sum.count[half]++;
            sum.squares += double(luminance(value)) * double(luminance(value));
            sum.position += white[i].position;
            sum.normal += white[i].frame.normal;
            if (hits[i].distance < kRayFar && (world.materialOf(hits[i].triangle).flags & kMaterialDoubleSided) == 0) {
                const World::Triangle& t = world.triangles()[hits[i].triangle];
                vec3 origin = world.vertices()[t.vertex[0]].position;
                vec3 normal = cross(world.vertices()[t.vertex[1]].position - origin, world.vertices()[t.vertex[2]].position - origin);
                sum.behind += dot(normal, packet[i].direction) > 0.0f ? 1 : 0;
            }
        }
        filled = 0;
    }
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
        if (context.progress.interrupted()) return;
        Unit& unit = units[i];
        std::uint64_t rays = 0;
        auto texels = rasteriseTile(context.transport.world, places, pageSizes[unit.page], pages[unit.page], unit.tile);
        uint seed = hash3(context.seed, unit.page, uint(unit.tile.y) * 65536u + uint(unit.tile.x));
        std::vector<TexelSum> sums(kTileTexels);
        for (int half = 0; half < 2; half++)
            for (int s = 0; s < (samples + 1 - half) / 2; s++) sampleTile(context, texels, seed, half, uint(s), sums, rays);

        Lightmap& page = result.pages[unit.page];
        for (int t = 0; t < kTileTexels; t++) {
            const TexelSum& sum = sums[std::size_t(t)];
            ivec2 at = unit.tile * kTileEdge + ivec2(t % kTileEdge, t / kTileEdge);
            int count = sum.count[0] + sum.count[1];
            if (count == 0 || at.x >= page.width || at.y >= page.height) continue;
            if (float(sum.behind) > kInvalidShare * float(count)) continue;
            std::size_t texel = std::size_t(at.y) * std::size_t(page.width) + std::size_t(at.x);
            dvec3 mean = (sum.half[0] + sum.half[1]) / double(count);
            page.texels[texel] = vec3(mean);
            page.valid[texel] = 1;
            TexelGuides& guides = result.guides[unit.page];
            guides.position[texel] = sum.position / float(count);
            guides.normal[texel] = safeNormalize(sum.normal, vec3(0.0f, 1.0f, 0.0f));
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
