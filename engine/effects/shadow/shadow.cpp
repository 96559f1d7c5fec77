#include "engine/effects/shadow/shadow.hpp"
#include "engine/graph/draw.hpp"

namespace afterglow
{
namespace
{
auto casters(const ShadowMaps& maps, const GpuScene& scene, DrawKind kind)
{
    return [&maps, &scene, kind](Draw& draw) {
        if (!scene.indices) return;
        draw.indices(scene.indices);
        for (std::size_t i = 0; i < maps.maps.size(); ++i) {
            draw.area(maps.areas[i]);
            for (const DrawItem& item : scene.draws) {
                const mat4& clip = maps.maps[i].worldToClip;
                if (item.kind != kind || !mayBeSeen(clip, item.lower, item.upper)) continue;
                const Instance& instance = item.instance;
                draw.push(ShadowPush{mat4(dmat4(clip) * dmat4(mat4(instance.toWorld))), maps.furthest[i], instance.material});
                draw.indexed(instance.indexCount, instance.firstIndex, int(instance.firstVertex));
            }
        }
    };
}
}

Shadows shadow(Graph& graph, ShadowMaps& maps, const GpuScene& scene)
{
    if (!maps.atlas) return {};
    const Shadows handles{graph.import(maps.atlas), graph.import(maps.views), graph.import(maps.first)};
    if (maps.drawn) return handles;
    maps.drawn = true;

    graph.raster("shadow", "engine/effects/shadow/shadow.vert", "engine/effects/shadow/shadow.frag")
        .write(handles.atlas)
        .push(ShadowPush{})
        .draw(casters(maps, scene, DrawKind::opaque));
    if (maps.masked)
        graph.raster("shadow.masked", "engine/effects/shadow/masked.vert", "engine/effects/shadow/masked.frag")
            .modify(handles.atlas)
            .push(ShadowPush{})
            .draw(casters(maps, scene, DrawKind::masked));
    return handles;
}
}
