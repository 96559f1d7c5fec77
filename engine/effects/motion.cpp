#include "engine/effects/motion.hpp"
#include "engine/effects/motion.h"
#include "engine/effects/surface_draws.hpp"

namespace afterglow
{
Texture movedSurfaces(Graph& graph, const std::string& name, const View& view, const GBuffer& surfaces, const GpuScene& scene)
{
    struct Moved {
        const DrawItem* item;
        MotionPush push;
    };
    std::vector<Moved> moved;
    for (const DrawItem& item : scene.draws)
        if (item.moved && item.kind != DrawKind::clear)
            moved.push_back(
                {&item, {mat4(dmat4(view.worldToClip) * dmat4(mat4(item.instance.toWorld))), mat4(view.last * dmat4(mat4(item.before)))}});
    if (moved.empty()) return {};
    const Texture texture = graph.texture("motion", VK_FORMAT_R32G32B32A32_SFLOAT, view.size);
    graph.raster(name, "engine/effects/motion.vert", "engine/effects/motion.frag")
        .read(surfaces.depth)
        .write(texture)
        .push(MotionPush{})
        .draw([moved, view, &scene](Draw& draw) {
            draw.indices(scene.indices);
            for (const Moved& one : moved) {
                draw.push(one.push);
                drawIndices(draw, view, *one.item);
            }
        });
    return texture;
}
}
