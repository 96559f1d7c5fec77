#include "engine/effects/layers.hpp"
#include "engine/effects/layers.h"

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

void surfaceLayers(Graph& graph, const View& view, const GBuffer& surfaces, Layers& layers)
{
    layers.surface = graph.texture("surface layer", VK_FORMAT_R32G32B32A32_SFLOAT, view.size);
    layers.ids = graph.texture("id layer", VK_FORMAT_R32G32_SFLOAT, view.size);
    graph.fullscreen("layers", "engine/effects/layers.frag")
        .read(graph.upload("layers", LayersFrame{view.clipToWorld, view.eye}))
        .read(surfaces.surface)
        .read(surfaces.depth)
        .read(surfaces.objects)
        .write(layers.surface)
        .write(layers.ids);
}
}
