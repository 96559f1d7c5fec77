// Reads irradiance back from a baked level on the CPU, by the same laws as the runtime: the lightmap of the nearest surface, or the probes.
#include "baker/baker.hpp"
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

// The lightmapped surface nearest to a point among those that face the way of `normal`.
static std::optional<vec3> fromSurface(const Baked& baked, const World& world, vec3 position, vec3 normal)
{
    float reach = kSurfaceReach * length(baked.scene.upper - baked.scene.lower);
    // From a little in front of the surface to a little behind it; other surfaces on the way are passed
    vec3 origin = position + normal * (0.01f * reach);
    float nearest = kRayFar;
    std::optional<vec3> found;
    for (float direction : {-1.0f, 1.0f}) {
        Ray ray{origin, normal * direction, reach};
        float travelled = 0.0f;
        for (int passed = 0; passed < 8; passed++) {
            Hit hit = world.closestHit(ray);
            if (!(hit.distance < kRayFar)) break;
            travelled += hit.distance;
            const World::Triangle& t = world.triangles()[hit.triangle];
            const Vertex &v0 = world.vertices()[t.vertex[0]], &v1 = world.vertices()[t.vertex[1]], &v2 = world.vertices()[t.vertex[2]];
            vec3 facing = normalize(cross(v1.position - v0.position, v2.position - v0.position));
            const LightmapPlace& place = baked.places[t.object];
            if (place.page >= 0 && dot(facing, normal) > kFacing) {
                float a = 1.0f - hit.barycentric.x - hit.barycentric.y;
                vec2 uv = (a * v0.uv1 + hit.barycentric.x * v1.uv1 + hit.barycentric.y * v2.uv1) * place.scale + place.offset;
                vec3 where = ray.origin + ray.direction * hit.distance;
                if (distance(where, position) < nearest) {
                    nearest = distance(where, position);
                    found = fromLightmap(baked.lightmaps[std::size_t(place.page)], uv);
                }
                break;
            }
            ray.origin += ray.direction * (hit.distance + 1e-5f * reach);
            ray.far = reach - travelled;
            if (!(ray.far > 0.0f)) break;
        }
    }
    return found;
}

std::vector<PointIrradiance> probeBaked(const Baked& baked, const std::vector<ProbePoint>& points)
{
    static const vec3 kAxes[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    World world(baked.scene, Content::staticOnly);
    std::vector<PointIrradiance> out(points.size());
    for (std::size_t i = 0; i < points.size(); i++) {
        if (points[i].normal) {
            vec3 normal = safeNormalize(*points[i].normal, vec3(0.0f, 1.0f, 0.0f));
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
