// Inside of row 7: `render --layers`, the parts of a picture in one OpenEXR file.
#pragma once
#include "engine/core/image.hpp"
#include "engine/frame/frame.hpp"
#include "engine/graph/executor.hpp"

namespace afterglow
{
// Marks what downloadLayers() will read.
void outputLayers(Graph& graph, const Pictures& pictures);

// Of the last run: the picture itself without a prefix and as `beauty`, then each part that the frame has. A part that this frame has
// nothing of is black, so that every file has the same layers and direct + indirect + reflection + emission + fog = beauty.
std::vector<Layer> downloadLayers(const Executor& executor, const Pictures& pictures);
}
