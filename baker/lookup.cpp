// Reads irradiance back from a baked level on the CPU: the lightmap of the nearest surface, or the probes by the law of the runtime.
#include "baker/baked_surface.hpp"
#include "baker/baker.hpp"
#include "engine/baked/probe_read.hpp"
#include "engine/core/error.hpp"
#include "engine/scene/origin.hpp"
#include "shaders/lightmap.h"
#include <algorithm>

namespace afterglow
{
static void demandProbes(const Baked& baked, std::size_t point)
{
    if (baked.probes.empty())
        throw Error("the bake knows nothing of the light at point " + std::to_string(point) +
                    ": it holds no irradiance probes and no lightmap there; bake it with probes, or ask for --truth");
}

std::vector<PointIrradiance> probeBaked(const Baked& baked, const std::vector<ProbePoint>& points)
{
    static const vec3 kAxes[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    World world(baked.scene, Content::staticOnly);
    Solids solids(LightTransport(world, baked.scene.lights));
    const ProbeSet probes{&baked.probes};
    std::vector<PointIrradiance> out(points.size());
    for (std::size_t i = 0; i < points.size(); i++) {
        const vec3 position = fromLevel(points[i].position, baked.scene.origin);
        if (points[i].normal) {
            vec3 normal = safeNormalize(*points[i].normal, vec3(0.0f, 1.0f, 0.0f));
            std::optional<SurfacePoint> surface = nearestSurface(baked, world, position, normal);
            if (!surface) demandProbes(baked, i);
            if (surface) out[i].open = openShare(baked, world, solids, *surface);
            out[i].value[0] = storedToIrradiance(surface ? out[i].open * lightmapValue(baked, world, *surface, normal)
                                                         : probeLookup(probes, offsetRay(position, normal), normal));
            continue;
        }
        demandProbes(baked, i);
        for (int side = 0; side < 6; side++)
            out[i].value[std::size_t(side)] = storedToIrradiance(probeLookup(probes, position, kAxes[side]));
    }
    return out;
}
}
