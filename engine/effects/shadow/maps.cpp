// Where the maps look, and where they lie in the atlas.
#include "engine/core/error.hpp"
#include "engine/effects/shadow/shadow.hpp"
#include "shaders/camera.h"
#include "shaders/frame.h"
#include <algorithm>
#include <limits>
#include <numeric>

namespace afterglow
{
namespace
{
constexpr uint kLargestAtlas = 8192; // texels on a side: 256 MiB of depth
constexpr float kNearest = 0.01f;    // m: what stands nearer to a spot or point light casts nothing

// World to a frame that looks along `forward` from `eye`.
mat4 lookAlong(const vec3& eye, const Frame& backward)
{
    const mat4 toWorld(vec4(backward.tangent, 0.0f), vec4(backward.bitangent, 0.0f), vec4(backward.normal, 0.0f), vec4(eye, 1.0f));
    return mat4(inverse(dmat4(toWorld)));
}

// A row of the matrix is a direction of the world, as long as clip space is dense along it.
vec3 rowOf(const mat4& worldToClip, int row) { return vec3(worldToClip[0][row], worldToClip[1][row], worldToClip[2][row]); }

// The map is 2 wide in clip space.
vec3 texelOf(const mat4& worldToClip, int row, float texels)
{
    const vec3 along = rowOf(worldToClip, row);
    return along * (2.0f / (texels * dot(along, along)));
}

float depthPerMetre(const mat4& orthographic) { return length(rowOf(orthographic, 2)); }

bool isSun(const Light& light) { return light.type == kLightDirectional; }

uint edgeOf(const Light& light, const ShadowParameters& p)
{
    if (light.type == kLightDirectional) return p.sunTexels;
    return light.type == kLightSpot ? p.spotTexels : p.faceTexels;
}

// Squares of powers of two along a Morton curve, largest first: no gaps, no overlap.
std::vector<uvec4> placeSquares(const std::vector<uint>& edges)
{
    std::vector<std::size_t> order(edges.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return edges[a] > edges[b]; });
    std::vector<uvec4> areas(edges.size());
    std::uint64_t along = 0; // texels covered so far
    for (const std::size_t i : order) {
        uvec2 at(0);
        for (uint bit = 0; bit < 16; ++bit) {
            at.x |= uint(along >> (2 * bit) & 1) << bit;
            at.y |= uint(along >> (2 * bit + 1) & 1) << bit;
        }
        areas[i] = uvec4(at, edges[i], edges[i]);
        along += std::uint64_t(edges[i]) * edges[i];
    }
    return areas;
}

uvec2 extentOf(const std::vector<uvec4>& areas)
{
    uvec2 extent(0);
    for (const uvec4& a : areas) extent = max(extent, uvec2(a.x + a.z, a.y + a.w));
    return extent;
}
}

mat4 sunClip(const Light& sun, const std::vector<DrawItem>& draws)
{
    const mat4 worldToLight = lookAlong(vec3(0.0f), makeFrame(-sun.direction));
    vec3 lower(std::numeric_limits<float>::max()), upper(-lower);
    for (const DrawItem& item : draws)
        for (int corner = 0; corner < 8; ++corner) {
            const vec3 p(corner & 1 ? item.upper.x : item.lower.x, corner & 2 ? item.upper.y : item.lower.y,
                         corner & 4 ? item.upper.z : item.lower.z);
            const vec3 q(worldToLight * vec4(p, 1.0f));
            lower = min(lower, q);
            upper = max(upper, q);
        }
    if (draws.empty()) lower = vec3(-1.0f), upper = vec3(1.0f);
    const vec3 half = max(0.505f * (upper - lower), vec3(1e-3f)); // 1 % more than the level: its rim has neighbours
    const vec3 middle = 0.5f * (lower + upper);
    mat4 centred(1.0f);
    centred[3] = vec4(-middle.x, -middle.y, 0.0f, 1.0f);
    return orthographicReversed(half.x, half.y, -middle.z - half.z, -middle.z + half.z) * centred * worldToLight;
}

mat4 spotClip(const Light& spot)
{
    const float angle = acos(clamp(spot.cosOuter, 0.05f, 0.9999f)); // a cone beyond 87 degrees is lit without shadow at its rim
    return perspectiveReversed(2.04f * angle, 1.0f, kNearest) * lookAlong(spot.position, makeFrame(-spot.direction));
}

mat4 faceClip(const Light& point, int face, float texels)
{
    const vec3 forward = cubeDirection(face, vec2(0.5f));
    // Wider than 90 degrees by the filter and the lift, so that a face finds at its rim what the next one sees there
    const float half = 1.0f + 6.0f * kShadowRadius / texels;
    return perspectiveReversed(2.0f * atan(half), 1.0f, kNearest) * lookAlong(point.position, makeFrame(-forward));
}

void aim(ShadowMaps& maps, std::size_t map, const mat4& worldToClip, bool parallel)
{
    const uvec4 area = maps.areas[map];
    ShadowView& view = maps.maps[map];
    view.worldToClip = worldToClip;
    view.scale = vec2(area.z, area.w) / vec2(maps.extent);
    view.offset = vec2(area.x, area.y) / vec2(maps.extent);
    view.inset = kShadowRadius / float(area.z);
    view.texelX = texelOf(worldToClip, 0, float(area.z));
    view.texelY = texelOf(worldToClip, 1, float(area.w));
    view.push = kShadowPush * std::max(length(view.texelX), length(view.texelY));
    view.lift = parallel ? orthographicRounding() : perspectiveRounding();
    maps.furthest[map] = parallel ? vec2(0.0f, view.push * depthPerMetre(worldToClip)) : vec2(view.push, 0.0f);
}

ShadowMaps makeShadowMaps(Gpu& gpu, const GpuScene& scene, const ShadowParameters& parameters, SunMaps sun)
{
    std::vector<float> halves;
    if (sun == SunMaps::cascades && std::any_of(scene.runtimeLights.begin(), scene.runtimeLights.end(), isSun))
        halves = cascadeHalves(std::max(distance(scene.lower, scene.upper), 1e-3f), parameters);
    std::vector<uint> edges;
    std::vector<int> first;
    for (const Light& light : scene.runtimeLights) {
        first.push_back(int(edges.size()));
        if (isSun(light)) edges.insert(edges.end(), halves.size(), parameters.cascadeTexels);
        edges.insert(edges.end(), light.type == kLightPoint ? 6 : 1, edgeOf(light, parameters));
    }
    ShadowMaps maps;
    if (edges.empty()) return maps;
    maps.areas = placeSquares(edges);
    while (std::max(extentOf(maps.areas).x, extentOf(maps.areas).y) > kLargestAtlas) {
        if (*std::max_element(edges.begin(), edges.end()) <= 16)
            throw Error("the level has " + std::to_string(first.size()) +
                        " lights, more than the shadow atlas holds; bake some of them with ag_bake = \"all\"");
        for (uint& edge : edges) edge = std::max(edge / 2, 16u);
        maps.areas = placeSquares(edges);
    }
    maps.extent = extentOf(maps.areas);
    const auto add = [&](const mat4& clip, bool parallel) {
        maps.maps.emplace_back();
        maps.furthest.emplace_back();
        aim(maps, maps.maps.size() - 1, clip, parallel);
    };
    for (const Light& light : scene.runtimeLights) {
        if (isSun(light)) {
            const mat4 level = sunClip(light, scene.draws);
            for (const float half : halves) {
                maps.cascades.push_back({maps.maps.size(), level, half, 0.5f * (scene.lower + scene.upper)});
                add(level, /* parallel= */ true); // until there is an eye to follow
            }
            add(level, /* parallel= */ true);
        } else if (light.type == kLightSpot) {
            add(spotClip(light), /* parallel= */ false);
        } else {
            for (int face = 0; face < 6; ++face) add(faceClip(light, face, float(maps.areas[maps.maps.size()].z)), /* parallel= */ false);
        }
    }
    maps.sunMaps = uint(halves.size()) + 1;
    for (const DrawItem& item : scene.draws) maps.masked |= item.kind == DrawKind::masked;

    maps.atlas = gpu.memory.image("shadow atlas", {.format = VK_FORMAT_D32_SFLOAT, .size = {maps.extent, 1}},
                                  VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT);
    maps.views = gpu.memory.buffer("shadow views", maps.maps.size() * sizeof(ShadowView), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    gpu.memory.upload(maps.views, maps.maps.data(), maps.maps.size() * sizeof(ShadowView));
    maps.first = gpu.memory.buffer("shadow first", first.size() * sizeof(int), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    gpu.memory.upload(maps.first, first.data(), first.size() * sizeof(int));
    return maps;
}
}
