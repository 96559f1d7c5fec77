// Bodies without a hole: an eye outside of one sees its fronts alone.
#pragma once
#include "engine/scene/scene.hpp"

namespace afterglow
{
// Vertices at the same place are one, so that seams of normals and texture coordinates are no holes. Every edge is run through as often one
// way as the other, and each connected part holds a volume that its fronts enclose. A part that crosses itself is taken at its word.
bool isClosedBody(const Scene& scene, const Primitive& primitive);
}
