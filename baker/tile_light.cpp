// A tile's texels are sampled up to sixteen at a time, neighbours that face the same way, for they share what their paths find (gather.hpp).
#include "baker/tile_light.hpp"
#include "baker/gather.hpp"
#include "engine/core/interrupt.hpp"
#include "shaders/lightmap.h"
#include <algorithm>
#include <cmath>

namespace afterglow
{
bool TexelLight::valid() const { return count[0] + count[1] > 0; }

vec3 TexelLight::ownNormal() const { return safeNormalize(vec3(normal / double(points)), vec3(0.0f, 1.0f, 0.0f)); }

static vec4 directionFrom(dvec3 light, dvec3 turn, vec3 normal)
{
    const double bright = double(luminance(vec3(light)));
    return bright > 0.0 ? directionAbout(vec3(turn / bright), normal) : directionUnbent();
}
vec4 TexelLight::direction() const { return directionFrom(half[0] + half[1], dvec3(turn[0]) + dvec3(turn[1]), ownNormal()); }
vec4 TexelLight::direction(int of) const { return directionFrom(half[of], dvec3(turn[of]), ownNormal()); }

double TexelLight::variance() const
{
    const int all = count[0] + count[1];
    const double bright = double(luminance(vec3(mean())));
    return std::max(squares / all - bright * bright, 0.0);
}

dvec3 TexelLight::halfDifference() const
{
    if (count[0] == 0 || count[1] == 0) return dvec3(0.0);
    // Of n paths, m of them in one half, a path's variance v makes (v / m + v / (n - m)) / 4 of the difference, and v / n of the mean
    const double own = 2.0 * std::sqrt(double(count[0]) * count[1]) / (count[0] + count[1]); // 1 where halves are as large
    return 0.5 * own * (half[0] / double(count[0]) - half[1] / double(count[1]));
}

void TexelLight::add(const TexelLight& layer, vec3 strength)
{
    if (!layer.valid()) return;
    if (!valid()) { // of all sums the first
        position = layer.position, normal = layer.normal, points = layer.points;
        for (int h = 0; h < 2; h++) count[h] = layer.count[h];
    }
    const int all = count[0] + count[1];
    const double paths = double(all) / (layer.count[0] + layer.count[1]), white = double(luminance(vec3(layer.mean()))),
                 gain = white > 0.0 ? double(luminance(strength * vec3(layer.mean()))) / white : 0.0;
    const double spread = variance() + gain * gain * paths * layer.variance();
    for (int h = 0; h < 2; h++)
        if (layer.count[h] > 0) half[h] += dvec3(strength) * layer.half[h] * (double(count[h]) / layer.count[h]);
    for (int h = 0; h < 2; h++) turn[h] += float(gain * paths) * layer.turn[h];
    const double bright = double(luminance(vec3(mean())));
    squares = all * (spread + bright * bright);
}

// Samples of one point of a texel, in two independent halves.
struct PointSum {
    dvec3 half[2] = {dvec3(0.0), dvec3(0.0)};
    double squares = 0.0;                     // of luminance
    dvec3 turn[2] = {dvec3(0.0), dvec3(0.0)}; // as TexelLight's
    int count[2] = {0, 0}, told[2] = {0, 0};
    vec3 more[2] = {vec3(0.0f), vec3(0.0f)};
    int samples() const { return count[0] + count[1]; }
};

// A point of a white surface.
struct White {
    vec3 position;                // world, m
    float meetingError;           // m, as Surface's
    vec3 normal, geometricNormal; // unit
};

static White whiteAt(const World& world, const TexelPoint& point)
{
    const World::Triangle& t = world.triangles()[point.triangle];
    const std::vector<Vertex>& v = world.vertices();
    const Vertex &v0 = v[t.vertex[0]], &v1 = v[t.vertex[1]], &v2 = v[t.vertex[2]];
    float b = point.barycentric.x, c = point.barycentric.y, a = 1.0f - b - c;
    vec3 geometric = safeNormalize(cross(v1.position - v0.position, v2.position - v0.position), vec3(0.0f, 1.0f, 0.0f));
    vec3 shading = safeNormalize(a * v0.normal + b * v1.normal + c * v2.normal, geometric);
    const vec3 position = a * v0.position + b * v1.position + c * v2.position;
    return {position, meetingError(v0.position - position, v1.position - position, v2.position - position),
            dot(shading, geometric) < 0.0f ? geometric : shading, geometric};
}

// The surface itself, seen from above.
static Bsdf baseAt(const World& world, const TexelPoint& point, vec3 normal)
{
    return world.surfaceAt(Ray{vec3(0.0f), -normal, kRayFar}, Hit{0.0f, point.triangle, point.barycentric}).bsdf;
}

// The tile's texels in an order of which each sixteen are a square: the nearer they are, the more of what one finds the others see.
static std::size_t texelAt(int place)
{
    static_assert(kTileEdge == 8 && kPacket == 16);
    const int square = place / kPacket, within = place % kPacket;
    return std::size_t((square / 2 * 4 + within / 4) * kTileEdge + square % 2 * 4 + within % 4);
}

static constexpr float kAlike = 0.8f; // cosine between normals; from 0.5 to 0.95 the error is the same within 5 %

namespace
{
// Texels that share paths.
struct Group {
    vec3 facing;
    std::vector<std::size_t> texels;
};
}

// Neighbours that face nearly the same way. Those that face otherwise see another part of what is there: how many of their rays find
// something for the others would be noise, which under an even sky were all there is.
static std::vector<Group> groupsOf(const World& world, const TilePoints& texels)
{
    std::vector<Group> groups;
    for (int place = 0; place < kTileTexels; place++) {
        const std::size_t texel = texelAt(place);
        if (texels[texel].empty()) continue;
        const vec3 facing = whiteAt(world, texels[texel].front()).geometricNormal;
        auto group = std::find_if(groups.begin(), groups.end(), [&](const Group& g) {
            return g.texels.size() < std::size_t(kPacket) && dot(g.facing, facing) >= kAlike;
        });
        if (group == groups.end()) group = groups.insert(group, {facing, {}});
        group->texels.push_back(texel);
    }
    return groups;
}

static constexpr uint kOfLights = 0x6c696768u; // seeds of light samples

// One sample of every texel of a group. Their directions are consecutive points of one set, of `seed`: evenly spread for few texels, too.
static void sampleOnce(BakeContext& context, const TilePoints& texels, const Group& of, uint tileSeed, uint seed, int half, uint index,
                       std::vector<std::vector<PointSum>>& sums, RayCount& rays)
{
    const World& world = context.transport.world;
    Tracer here{&context.transport, &context.direct, &rays};
    Tracer beyond{&context.transport, &context.transport.lights, &rays};
    beyond.cache = context.cache.get(), beyond.half = half;
    Neighbours group;
    group.tells = context.tells;
    group.directional = context.directional;
    group.count = int(of.texels.size());
    group.sample = index;
    uint ofTexel[kPacket] = {};
    for (int i = 0; i < group.count; i++) ofTexel[i] = uint(of.texels[std::size_t(i)]) + 1u;
    Lanes pick, x, y;
    for (int i = 0; i < kPacket; i++) {
        Sampler random = makeSampler(hash3(tileSeed, ofTexel[i], uint(half)), index),
                direction = makeSampler(seed, index * uint(group.count) + uint(i));
        pick[i] = next1(random);
        group.random[i] = random;
        group.lightSeed[i] = hash3(tileSeed ^ kOfLights, ofTexel[i], uint(half));
        const vec2 u = next2(direction);
        x[i] = u.x, y[i] = u.y;
    }
    PointSum* owner[kPacket];
    for (int i = 0; i < group.count; i++) {
        const std::size_t texel = of.texels[std::size_t(i)], point = std::size_t(pick[i] * float(texels[texel].size()));
        const White white = whiteAt(world, texels[texel][point]);
        const vec3 origin = leaving(white.position, white.meetingError, white.geometricNormal);
        group.white.set(i, white.position, origin, white.normal, white.geometricNormal);
        if (group.tells) group.base[i] = baseAt(world, texels[texel][point], white.geometricNormal);
        group.rays[i] = Ray{origin, toWorld(makeFrame(white.normal), sampleCosineHemisphere(vec2(x[i], y[i]))), kRayFar};
        owner[i] = &sums[texel][point];
    }
    gather(here, beyond, group);
    for (int i = 0; i < group.count; i++) {
        const vec3 value = group.irradiance[i];
        if (!isFinite(value) || (group.tells && !isFinite(group.more[i]))) { // NaN or overflow: dropped, the mean is over what is finite
            rays.notFinite++;
            continue;
        }
        PointSum& sum = *owner[i];
        sum.half[half] += dvec3(value);
        sum.count[half]++;
        sum.squares += double(luminance(value)) * double(luminance(value));
        sum.turn[half] += dvec3(group.turn[i]);
        if (!group.tells) continue;
        sum.more[half] += group.more[i];
        sum.told[half]++;
    }
}

// Adds what the points of a texel brought.
static void addPoints(const World& world, const std::vector<TexelPoint>& points, const std::vector<PointSum>& sums, bool tells,
                      TexelLight& texel)
{
    for (std::size_t p = 0; p < points.size(); p++) {
        const PointSum& sum = sums[p];
        if (sum.samples() == 0) continue;
        for (int half = 0; half < 2; half++) {
            texel.half[half] += sum.half[half];
            texel.count[half] += sum.count[half];
            texel.more[half] += sum.more[half];
            if (tells) texel.told[half] += sum.told[half];
            texel.turn[half] += vec3(sum.turn[half]);
        }
        texel.squares += sum.squares;
        const White white = whiteAt(world, points[p]);
        texel.position += dvec3(white.position);
        texel.normal += dvec3(white.normal);
        texel.points++;
    }
}

void sampleTile(BakeContext& context, const TilePoints& texels, uint tileSeed, int first, int last, std::vector<TexelLight>& light,
                RayCount& rays)
{
    std::vector<std::vector<PointSum>> sums;
    for (const auto& points : texels) sums.emplace_back(points.size());
    const std::vector<Group> groups = groupsOf(context.transport.world, texels);
    for (int half = 0; half < 2; half++) {
        const uint directions = hash3(tileSeed, uint(half), 0x64697265u);
        for (int s = (first + 1 - half) / 2; s < (last + 1 - half) / 2; s++) {
            stopIfInterrupted();
            for (uint g = 0; g < groups.size(); g++)
                sampleOnce(context, texels, groups[g], tileSeed, hash2(directions, g), half, uint(s), sums, rays);
        }
    }
    // What a texel on both sides of a wall has found is of no use to paths
    const auto parted = context.tells ? partedTexels(context.transport.world, texels) : std::bitset<kTileTexels>();
    for (std::size_t t = 0; t < texels.size(); t++) addPoints(context.transport.world, texels[t], sums[t], !parted[t], light[t]);
}
}
