// Upscale: a picture drawn smaller, brought to the size that is shown, from this one frame alone. Where frames are gathered, antialias does
// it.
#pragma once
#include "engine/effects/view.hpp"

namespace afterglow
{
Texture upscale(Graph& graph, const View& view, const Texture& image, uvec2 shown);
}
