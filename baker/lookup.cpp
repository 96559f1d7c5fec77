// Reads irradiance back from a baked level on the CPU, by the same laws as the runtime: the lightmap of the nearest surface, or the probes.
#include "baker/baker.hpp"
#include "baker/irradiance.hpp"
#include "baker/world.hpp"
#include "shaders/lightmap.h"
#include "shaders/probe.h"
#include <algorithm>

namespace afterglow
{
static constexpr float kSurfaceReach = 0.02f; // share of the level's size within which a surface belongs to a point
static constexpr float kFacing = 0.5f;        // cosine between the asked normal and the surface's

// Irradiance / pi about a normal from the volume nearest around a point; nothing when all eight probes are invalid.
static std::optional<vec3> fromVolume(const ProbeVolume& volume, vec3 position, vec3 normal)
{
    vec3 unit(inverse(volume.toWorld) * vec4(position, 1.0f));
    ProbeCell cell = probeCell(unit, volume.count);
    vec3 sum(0.0f);
    float weights = 0.0f;
    for (int corner = 0; corner < 8; corner++) {
        ivec3 at = probeCorner(cell, corner, volume.count);
        std::size_t probe = std::size_t(probeIndex(at, volume.count));
        vec3 there(volume.toWorld * vec4(probeUnitPosition(at, volume.count), 1.0f));
        float weight = probeWeight(probeTrilinear(cell, corner), volume.validity[probe], there - position, normal);
        sum += weight * shIrradiance(volume.irradiance[probe], normal);
        weights += weight;
    }
    if (!(weights > 0.0f)) return std::nullopt;
    return sum / weights;
}

static vec3 fromProbes(const Baked& baked, vec3 position, vec3 normal)
{
    // The volume that contains the point, the first when none does: lookups outside are clamped to the border
    const ProbeVolume* chosen = baked.probes.empty() ? nullptr : &baked.probes[0];
    for (const ProbeVolume& volume : baked.probes) {
        vec3 unit = abs(vec3(inverse(volume.toWorld) * vec4(position, 1.0f)));
        if (max(max(unit.x, unit.y), unit.z) <= 0.5f) {
            chosen = &volume;
            break;
        }
    }
    return chosen ? fromVolume(*chosen, position, normal).value_or(vec3(0.0f)) : vec3(0.0f);
}

// Bilinear over texels that hold data.
static vec3 fromLightmap(const Lightmap& page, vec2 uv)
{
    vec2 p = uv * vec2(float(page.width), float(page.height)) - 0.5f;
    vec2 cell = floor(p);
    vec3 sum(0.0f);
    float weights = 0.0f;
    for (int corner = 0; corner < 4; corner++) {
        ivec2 at = clamp(ivec2(cell) + ivec2(corner & 1, corner >> 1), ivec2(0), ivec2(page.width - 1, page.height - 1));
        vec2 f = p - cell;
        float weight = ((corner & 1) ? f.x : 1.0f - f.x) * ((corner >> 1) ? f.y : 1.0f - f.y);
        std::size_t texel = std::size_t(at.y) * std::size_t(page.width) + std::size_t(at.x);
        if (page.valid[texel] == 0) continue;
        sum += weight * page.texels[texel];
        weights += weight;
    }
    return weights > 0.0f ? sum / weights : vec3(0.0f);
}

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

// The lightmapped surface nearest to a point among those that face the way of `normal`. All triangles are asked: surfaces that touch each
// other face to face cannot be told apart by a ray.
static std::optional<vec3> fromSurface(const Baked& baked, const World& world, vec3 position, vec3 normal)
{
    float nearest = kSurfaceReach * length(baked.scene.upper - baked.scene.lower);
    std::optional<vec3> found;
    for (const World::Triangle& t : world.triangles()) {
        const LightmapPlace& place = baked.places[t.object];
        if (place.page < 0) continue;
        const Vertex &v0 = world.vertices()[t.vertex[0]], &v1 = world.vertices()[t.vertex[1]], &v2 = world.vertices()[t.vertex[2]];
        vec3 lower = min(min(v0.position, v1.position), v2.position) - nearest,
             upper = max(max(v0.position, v1.position), v2.position) + nearest;
        if (any(lessThan(position, lower)) || any(greaterThan(position, upper))) continue;
        vec3 facing = safeNormalize(cross(v1.position - v0.position, v2.position - v0.position), vec3(0.0f));
        if (!(dot(facing, normal) > kFacing)) continue;
        vec2 b = nearestOnTriangle(position, v0.position, v1.position, v2.position);
        float a = 1.0f - b.x - b.y;
        float apart = distance(position, a * v0.position + b.x * v1.position + b.y * v2.position);
        if (!(apart < nearest)) continue;
        nearest = apart;
        found =
            fromLightmap(baked.lightmaps[std::size_t(place.page)], (a * v0.uv1 + b.x * v1.uv1 + b.y * v2.uv1) * place.scale + place.offset);
    }
    return found;
}

// A surface point that another solid covers (a floor under a wall) lies in the dark, whatever its texel holds for the visible points beside
// it: most rays that leave it meet the back of something. Not all: solids overlap.
static bool isBuried(const World& world, vec3 position, vec3 normal)
{
    constexpr uint kRays = 32;
    uint backs = 0;
    Surface white = whiteSurface(position, normal, normal);
    for (uint i = 0; i < kRays; i++) {
        Sampler random = makeSampler(0u, i);
        Ray ray = cosineRay(white, next2(random));
        Hit hit = world.closestHit(ray);
        if (hit.distance < kRayFar && world.surfaceAt(ray, hit).frontFacing == 0.0f) backs++;
    }
    return 2 * backs > kRays;
}

std::vector<PointIrradiance> probeBaked(const Baked& baked, const std::vector<ProbePoint>& points)
{
    static const vec3 kAxes[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    World world(baked.scene, Content::staticOnly);
    std::vector<PointIrradiance> out(points.size());
    for (std::size_t i = 0; i < points.size(); i++) {
        if (points[i].normal) {
            vec3 normal = safeNormalize(*points[i].normal, vec3(0.0f, 1.0f, 0.0f));
            if (isBuried(world, points[i].position, normal)) continue;
            std::optional<vec3> surface = fromSurface(baked, world, points[i].position, normal);
            out[i].value[0] = storedToIrradiance(surface ? *surface : fromProbes(baked, points[i].position, normal));
            continue;
        }
        for (int side = 0; side < 6; side++)
            out[i].value[std::size_t(side)] = storedToIrradiance(fromProbes(baked, points[i].position, kAxes[side]));
    }
    return out;
}
}
