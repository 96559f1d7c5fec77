// Cuts the meshes of a level where walls, plates and bodies part their surfaces, so that no texel lies on both sides: light would come
// through it. This work is done before the atlas is.
#pragma once
#include "baker/atlas.hpp"

namespace afterglow
{
// Rewrites the primitives of meshes that are parted; an object whose mesh others use too gets one of its own. Triangles keep their order,
// each in its parts. What is not parted does not change.
Pieces partMeshes(Scene& scene, double texelsPerMetre, int threads);
}
