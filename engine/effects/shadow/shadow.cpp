#include "engine/effects/shadow/shadow.hpp"
#include "engine/graph/draw.hpp"
#include <numeric>

namespace afterglow
{
namespace
{
enum class Ground { clear, kept }; // what an area holds before its casters are drawn

auto casters(const ShadowMaps& maps, const std::vector<std::size_t>& which, const GpuScene& scene, DrawKind kind, Ground ground)
{
    return [&maps, which, &scene, kind, ground](Draw& draw) {
        if (ground == Ground::clear)
            for (const std::size_t i : which) draw.clearDepth(maps.areas[i]);
        if (!scene.indices) return;
        draw.indices(scene.indices);
        for (const std::size_t i : which) {
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

// Lets the cascades follow the eye. The maps that are to be drawn: those that moved, or all of them at first.
std::vector<std::size_t> follow(ShadowMaps& maps, const View& view)
{
    std::vector<std::size_t> moved;
    for (const Cascade& cascade : maps.cascades) {
        const mat4 clip = cascadeClip(cascade, view);
        if (clip == maps.maps[cascade.map].worldToClip) continue;
        aim(maps, cascade.map, clip, /* parallel= */ true);
        moved.push_back(cascade.map);
    }
    if (maps.drawn) return moved;
    std::vector<std::size_t> all(maps.maps.size());
    std::iota(all.begin(), all.end(), std::size_t(0));
    return all;
}
}

Shadows shadow(Graph& graph, ShadowMaps& maps, const GpuScene& scene, const View& view)
{
    if (!maps.atlas) return {};
    const std::vector<std::size_t> which = follow(maps, view);
    const Texture atlas = graph.import(maps.atlas);
    const Buffer views =
        maps.cascades.empty() ? graph.import(maps.views) : graph.upload("shadow views", std::span<const ShadowView>(maps.maps));
    const Shadows handles{atlas, views, graph.import(maps.first), maps.sunMaps};
    if (which.empty()) return handles;

    const std::string name = maps.drawn ? "shadow.cascades" : "shadow";
    Pass opaque = graph.raster(name, "engine/effects/shadow/shadow.vert", "engine/effects/shadow/shadow.frag").push(ShadowPush{});
    if (maps.drawn)
        opaque.modify(atlas).draw(casters(maps, which, scene, DrawKind::opaque, Ground::clear));
    else
        opaque.write(atlas).draw(casters(maps, which, scene, DrawKind::opaque, Ground::kept));
    if (maps.masked)
        graph.raster(name + ".masked", "engine/effects/shadow/masked.vert", "engine/effects/shadow/masked.frag")
            .modify(atlas)
            .push(ShadowPush{})
            .draw(casters(maps, which, scene, DrawKind::masked, Ground::kept));
    maps.drawn = true;
    return handles;
}
}
