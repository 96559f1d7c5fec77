#include "engine/effects/layers.hpp"
#include "engine/effects/layers.h"
#include "engine/effects/motion.hpp"

namespace afterglow
{
void writeAll(Pass& pass, const Layers& layers)
{
    pass.write(layers.reflection).write(layers.direct).write(layers.indirect).write(layers.emission);
}

void modifyAll(Pass& pass, const Layers& layers)
{
    pass.modify(layers.reflection).modify(layers.direct).modify(layers.indirect).modify(layers.emission);
}

void surfaceLayers(Graph& graph, const View& view, const GBuffer& surfaces, const GpuScene& scene, Layers& layers)
{
    const Texture moved = movedSurfaces(graph, "motion", view, surfaces, scene);
    const bool rests = view.last == view.steady;
    const mat4 toLast = rests ? mat4(1.0f) : mat4(view.last * inverse(view.steady));
    layers.surface = graph.texture("surface layer", VK_FORMAT_R32G32B32A32_SFLOAT, view.size);
    layers.ids = graph.texture("id layer", VK_FORMAT_R32G32_SFLOAT, view.size);
    if (moved || !rests) layers.motion = graph.texture("motion layer", VK_FORMAT_R32G32B32A32_SFLOAT, view.size);
    graph.fullscreen("surfaces", "engine/effects/layers.frag")
        .read(graph.upload("surfaces", LayersFrame{view.clipToWorld, toLast, view.eye}))
        .read(surfaces.surface)
        .read(surfaces.depth)
        .read(surfaces.objects)
        .read(moved)
        .write(layers.surface)
        .write(layers.ids)
        .write(layers.motion)
        .specialize(kLayersMoved, bool(moved));
}
}
