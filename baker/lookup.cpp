// Reads irradiance back from a baked level on the CPU: the lightmap of the nearest surface, or the probes about a point.
#include "baker/baked_surface.hpp"
#include "baker/baker.hpp"
#include "shaders/lightmap.h"
#include "shaders/probe.h"
#include <algorithm>

namespace afterglow
{
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

std::vector<PointIrradiance> probeBaked(const Baked& baked, const std::vector<ProbePoint>& points)
{
    static const vec3 kAxes[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    World world(baked.scene, Content::staticOnly);
    Solids solids(LightTransport(world, baked.scene.lights));
    std::vector<PointIrradiance> out(points.size());
    for (std::size_t i = 0; i < points.size(); i++) {
        if (points[i].normal) {
            vec3 normal = safeNormalize(*points[i].normal, vec3(0.0f, 1.0f, 0.0f));
            std::optional<SurfacePoint> surface = nearestSurface(baked, world, points[i].position, normal);
            if (surface) out[i].open = openShare(baked, world, solids, *surface);
            out[i].value[0] = storedToIrradiance(surface ? out[i].open * lightmapValue(baked, world, *surface)
                                                         : fromProbes(baked, points[i].position, normal));
            continue;
        }
        for (int side = 0; side < 6; side++)
            out[i].value[std::size_t(side)] = storedToIrradiance(fromProbes(baked, points[i].position, kAxes[side]));
    }
    return out;
}
}
