// Inside of row 7: `render --layers`, the parts of a picture in one OpenEXR file.
#pragma once
#include "engine/core/image.hpp"
#include "engine/frame/frame.hpp"
#include "engine/graph/executor.hpp"

namespace afterglow
{
// Marks what downloadLayers() will read.
void outputLayers(Graph& graph, const Pictures& pictures);

// Of the last run: the picture itself without a prefix and as `beauty`, then its parts. Every file has the same layers: a part that this
// frame has nothing of is black, what nothing occludes is open, what rests has no motion. Of what is gathered, each pixel is a mean:
//   direct + indirect + reflection + emission + fog = beauty, scene-linear; beauty + bloom is what is exposed and displayed.
//   ao.Y: which share of the light from everywhere arrives. The parts hold it already: it is for looking at, and for other light.
// Of the surface at the pixel's centre:
//   depth.Z: m along the view axis, 1e10 in the sky; normal.XYZ: in the level's world, +y up
//   motion.XYZW: px, right and up; xy from here to the last frame, zw from the next to here. What is clear moves as what lies behind it
//   object_id.X, material_id.X: 1 + the index in the level; 0 in the sky
std::vector<Layer> downloadLayers(const Executor& executor, const Pictures& pictures);
}
