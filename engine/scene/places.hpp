// Vertices that lie at the same place, whatever else tells them apart: seams of normals and of texture coordinates.
#pragma once
#include "shaders/scene.h"
#include <span>
#include <vector>

namespace afterglow
{
using namespace shared;

// Of every vertex: the first at its place.
std::vector<uint> firstOfPlace(std::span<const Vertex> vertices);
}
