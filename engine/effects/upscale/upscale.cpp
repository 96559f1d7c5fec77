#include "engine/effects/upscale/upscale.hpp"
#include "engine/effects/upscale/upscale.h"

namespace afterglow
{
Texture upscale(Graph& graph, const View& view, const Texture& image, uvec2 shown)
{
    const Texture upscaled = graph.texture("upscaled", image.format(), shown);
    graph.fullscreen("upscale", "engine/effects/upscale/upscale.frag").read(image).write(upscaled).push(UpscalePush{view.jitter});
    return upscaled;
}
}
