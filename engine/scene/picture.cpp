#include "engine/scene/picture.hpp"
#include "engine/scene/flats.hpp"

namespace afterglow
{
PortalTable portalTable(const Scene& scene)
{
    PortalTable table;
    table.ofInstance.assign(instances(scene).size(), -1);
    for (const Flat& flat : findFlats(scene).portals) {
        for (const uint surface : flat.surfaces) table.ofInstance[surface] = int(table.portals.size());
        table.portals.push_back({mat4x3(flat.through), vec3(flat.normal), vec3(flat.beyond)});
    }
    return table;
}

Picture pictureOf(const Camera& camera, uvec2 size, uint seed, uint portalDepth)
{
    const mat4 lens = projection(camera, size);
    return {mat4x3(camera.toWorld), vec2(lens[0][0], lens[1][1]), uint(camera.fovY > 0.0f), portalDepth, size, seed};
}
}
