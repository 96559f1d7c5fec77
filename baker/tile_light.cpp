// A tile's texels are sampled sixteen at a time, neighbours together, for they share what their paths find (gather.hpp).
#include "baker/tile_light.hpp"
#include "baker/gather.hpp"
#include "baker/irradiance.hpp"
#include "engine/core/interrupt.hpp"
#include "shaders/lightmap.h"
#include <algorithm>

namespace afterglow
{
bool TexelLight::valid() const { return count[0] + count[1] > 0; }

vec4 TexelLight::direction() const
{
    const double light = double(luminance(vec3(half[0] + half[1])));
    if (!(light > 0.0)) return directionUnbent();
    const vec3 own = safeNormalize(vec3(normal / double(points)), vec3(0.0f, 1.0f, 0.0f));
    return directionAbout(vec3(dvec3(turn) / light), own);
}

double TexelLight::variance() const
{
    const int all = count[0] + count[1];
    const double bright = double(luminance(vec3(mean())));
    return std::max(squares / all - bright * bright, 0.0);
}

dvec3 TexelLight::halfDifference() const
{
    if (count[0] == 0 || count[1] == 0) return dvec3(0.0);
    return 0.5 * (half[0] / double(count[0]) - half[1] / double(count[1]));
}

// Samples of one point of a texel, in two independent halves.
struct PointSum {
    dvec3 half[2] = {dvec3(0.0), dvec3(0.0)};
    double squares = 0.0; // of luminance
    dvec3 turn{0.0};      // as TexelLight's
    int count[2] = {0, 0};
    int samples() const { return count[0] + count[1]; }
};

static Surface whiteAt(const World& world, const TexelPoint& point)
{
    const World::Triangle& t = world.triangles()[point.triangle];
    const std::vector<Vertex>& v = world.vertices();
    const Vertex &v0 = v[t.vertex[0]], &v1 = v[t.vertex[1]], &v2 = v[t.vertex[2]];
    float b = point.barycentric.x, c = point.barycentric.y, a = 1.0f - b - c;
    vec3 geometric = normalize(cross(v1.position - v0.position, v2.position - v0.position));
    vec3 shading = safeNormalize(a * v0.normal + b * v1.normal + c * v2.normal, geometric);
    const vec3 position = a * v0.position + b * v1.position + c * v2.position;
    return whiteSurface(position, dot(shading, geometric) < 0.0f ? geometric : shading, geometric,
                        meetingError(v0.position - position, v1.position - position, v2.position - position));
}

// The tile's texels in an order of which each sixteen are a square: the nearer they are, the more of what one finds the others see.
static std::size_t texelAt(int place)
{
    static_assert(kTileEdge == 8 && kPacket == 16);
    const int square = place / kPacket, within = place % kPacket;
    return std::size_t((square / 2 * 4 + within / 4) * kTileEdge + square % 2 * 4 + within % 4);
}

// One sample of every texel of the tile.
static void sampleOnce(BakeContext& context, const TilePoints& texels, uint tileSeed, int half, uint index,
                       std::vector<std::vector<PointSum>>& sums, RayCount& rays)
{
    const World& world = context.transport.world;
    Tracer here{&context.transport, &context.direct, &rays};
    Tracer beyond{&context.transport, &context.transport.lights, &rays};
    const uint directions = hash3(tileSeed, uint(half), 0x64697265u);

    Neighbours group;
    group.directional = context.directional;
    PointSum* owner[kPacket];
    for (int place = 0; place <= kTileTexels; place++) {
        const std::size_t texel = place < kTileTexels ? texelAt(place) : 0;
        if (place < kTileTexels && !texels[texel].empty()) {
            const auto& points = texels[texel];
            Sampler& random = group.random[group.count];
            random = makeSampler(hash3(tileSeed, uint(texel) + 1u, uint(half)), index);
            std::size_t pick = std::size_t(next1(random) * float(points.size()));
            // The directions of a group are one even set
            Sampler direction = makeSampler(hash2(directions, uint(place) / uint(kPacket)), index * uint(kPacket) + uint(group.count));
            group.white[group.count] = whiteAt(world, points[pick]);
            group.rays[group.count] = cosineRay(group.white[group.count], next2(direction));
            owner[group.count++] = &sums[texel][pick];
        }
        if (group.count == 0 || (group.count < kPacket && place < kTileTexels)) continue;
        gather(here, beyond, group);
        for (int i = 0; i < group.count; i++) {
            const vec3 value = group.irradiance[i];
            if (!isFinite(value)) { // NaN or overflow: dropped, the mean is over what is finite
                context.notFinite++;
                continue;
            }
            PointSum& sum = *owner[i];
            sum.half[half] += dvec3(value);
            sum.count[half]++;
            sum.squares += double(luminance(value)) * double(luminance(value));
            sum.turn += group.turn[i];
        }
        group.count = 0;
    }
}

// Adds what the points of a texel brought.
static void addPoints(const World& world, const std::vector<TexelPoint>& points, const std::vector<PointSum>& sums, TexelLight& texel)
{
    for (std::size_t p = 0; p < points.size(); p++) {
        const PointSum& sum = sums[p];
        if (sum.samples() == 0) continue;
        for (int half = 0; half < 2; half++) {
            texel.half[half] += sum.half[half];
            texel.count[half] += sum.count[half];
        }
        texel.squares += sum.squares;
        texel.turn += vec3(sum.turn);
        const Surface white = whiteAt(world, points[p]);
        texel.position += dvec3(white.position);
        texel.normal += dvec3(white.frame.normal);
        texel.points++;
    }
}

void sampleTile(BakeContext& context, const TilePoints& texels, uint tileSeed, int first, int last, std::vector<TexelLight>& light,
                RayCount& rays)
{
    std::vector<std::vector<PointSum>> sums;
    for (const auto& points : texels) sums.emplace_back(points.size());
    for (int half = 0; half < 2; half++)
        for (int s = (first + 1 - half) / 2; s < (last + 1 - half) / 2; s++) {
            stopIfInterrupted();
            sampleOnce(context, texels, tileSeed, half, uint(s), sums, rays);
        }
    for (std::size_t t = 0; t < texels.size(); t++) addPoints(context.transport.world, texels[t], sums[t], light[t]);
}
}
