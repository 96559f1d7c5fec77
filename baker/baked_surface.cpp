#include "baker/baked_surface.hpp"
#include "baker/irradiance.hpp"
#include "shaders/lightmap.h"
#include <algorithm>
#include <cmath>

namespace afterglow
{
static constexpr float kSurfaceReach = 0.02f; // share of the level's size within which a surface belongs to a point
static constexpr float kFacing = 0.5f;        // cosine between the asked normal and the surface's
static constexpr int kShareEdge = 8;          // positions along a texel's edge

// Barycentric weights of the second and third corner of the point of a triangle nearest to p (Ericson 2005, 5.1.5).
static vec2 nearestOnTriangle(vec3 p, vec3 a, vec3 b, vec3 c)
{
    vec3 ab = b - a, ac = c - a;
    float d1 = dot(ab, p - a), d2 = dot(ac, p - a), d3 = dot(ab, p - b), d4 = dot(ac, p - b), d5 = dot(ab, p - c), d6 = dot(ac, p - c);
    if (d1 <= 0.0f && d2 <= 0.0f) return vec2(0.0f);
    if (d3 >= 0.0f && d4 <= d3) return vec2(1.0f, 0.0f);
    if (d6 >= 0.0f && d5 <= d6) return vec2(0.0f, 1.0f);
    float va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0f && d1 >= 0.0f && d3 <= 0.0f) return vec2(d1 / (d1 - d3), 0.0f);
    if (vb <= 0.0f && d2 >= 0.0f && d6 <= 0.0f) return vec2(0.0f, d2 / (d2 - d6));
    if (va <= 0.0f && d4 >= d3 && d5 >= d6) {
        float t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return vec2(1.0f - t, t);
    }
    return vec2(vb, vc) / (va + vb + vc);
}

// A triangle's corners in space and on its page.
struct Corners {
    vec3 position[3];
    vec2 texel[3];
    vec3 at(vec2 b) const { return (1.0f - b.x - b.y) * position[0] + b.x * position[1] + b.y * position[2]; }
    vec2 onPage(vec2 b) const { return (1.0f - b.x - b.y) * texel[0] + b.x * texel[1] + b.y * texel[2]; }
};
static Corners cornersOf(const Baked& baked, const World& world, uint triangle)
{
    const World::Triangle& t = world.triangles()[triangle];
    const LightmapPlace& place = baked.places[t.object];
    const Lightmap& page = baked.lightmaps[std::size_t(place.page)];
    Corners corners;
    for (int i = 0; i < 3; i++) {
        const Vertex& v = world.vertices()[t.vertex[i]];
        corners.position[i] = v.position;
        corners.texel[i] = (v.uv1 * place.scale + place.offset) * vec2(float(page.width), float(page.height));
    }
    return corners;
}

std::optional<SurfacePoint> nearestSurface(const Baked& baked, const World& world, vec3 position, vec3 normal)
{
    float nearest = kSurfaceReach * length(baked.scene.upper - baked.scene.lower);
    std::optional<SurfacePoint> found;
    for (uint i = 0; i < world.triangles().size(); i++) {
        const World::Triangle& t = world.triangles()[i];
        if (baked.places[t.object].page < 0) continue;
        vec3 v0 = world.vertices()[t.vertex[0]].position, v1 = world.vertices()[t.vertex[1]].position,
             v2 = world.vertices()[t.vertex[2]].position;
        if (any(lessThan(position, min(min(v0, v1), v2) - nearest)) || any(greaterThan(position, max(max(v0, v1), v2) + nearest))) continue;
        if (!(dot(safeNormalize(world.front(i), vec3(0.0f)), normal) > kFacing)) continue;
        vec2 b = nearestOnTriangle(position, v0, v1, v2);
        float apart = distance(position, (1.0f - b.x - b.y) * v0 + b.x * v1 + b.y * v2);
        if (!(apart < nearest)) continue;
        nearest = apart;
        found = SurfacePoint{i, b};
    }
    return found;
}

vec3 lightmapValue(const Baked& baked, const World& world, SurfacePoint point, vec3 normal)
{
    const Lightmap& page = baked.lightmaps[std::size_t(baked.places[world.triangles()[point.triangle].object].page)];
    vec2 p = cornersOf(baked, world, point.triangle).onPage(point.barycentric) - 0.5f;
    vec2 cell = floor(p);
    vec3 sum(0.0f);
    vec4 direction(0.0f);
    float weights = 0.0f;
    for (int corner = 0; corner < 4; corner++) {
        ivec2 at = clamp(ivec2(cell) + ivec2(corner & 1, corner >> 1), ivec2(0), ivec2(page.width - 1, page.height - 1));
        vec2 f = p - cell;
        float weight = ((corner & 1) ? f.x : 1.0f - f.x) * ((corner >> 1) ? f.y : 1.0f - f.y);
        std::size_t texel = std::size_t(at.y) * std::size_t(page.width) + std::size_t(at.x);
        if (page.valid[texel] == 0) continue;
        sum += weight * page.texels[texel];
        if (!page.direction.empty()) direction += weight * page.direction[texel];
        weights += weight;
    }
    if (!(weights > 0.0f)) return vec3(0.0f);
    return page.direction.empty() ? sum / weights : directionShare(direction / weights, normal) * (sum / weights);
}

float openShare(const Baked& baked, const World& world, const Solids& solids, SurfacePoint point)
{
    // Positions of a texel-sized square about the point, from the page into the triangle; those beyond its edges are not of this surface
    Corners corners = cornersOf(baked, world, point.triangle);
    vec2 along1 = corners.texel[1] - corners.texel[0], along2 = corners.texel[2] - corners.texel[0];
    float area = along1.x * along2.y - along1.y * along2.x;
    vec3 normal = safeNormalize(world.front(point.triangle), vec3(0.0f, 1.0f, 0.0f));
    std::vector<SurfacePlace> places;
    for (int i = 0; i < kShareEdge * kShareEdge && area != 0.0f; i++) {
        vec2 d = (vec2(float(i % kShareEdge), float(i / kShareEdge)) + 0.5f) / float(kShareEdge) - 0.5f;
        vec2 b = point.barycentric + vec2(d.x * along2.y - d.y * along2.x, along1.x * d.y - along1.y * d.x) / area;
        if (b.x >= 0.0f && b.y >= 0.0f && b.x + b.y <= 1.0f) places.push_back({corners.at(b), normal});
    }
    if (places.empty()) places.push_back({corners.at(point.barycentric), normal});
    const std::vector<Stand> stands = solids.standsOf(places);
    return float(std::count(stands.begin(), stands.end(), Stand::open)) / float(stands.size());
}
}
