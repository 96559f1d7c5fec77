// A level of as many triangles as one likes, to ask how time grows with them.
#pragma once
#include "engine/scene/scene.hpp"

namespace afterglow
{
// A closed room of 10 x 5 x 10 m with forty closed bodies in it, each a mesh of its own, and a camera that sees most of them. Whatever
// their number, the surfaces are the same; more triangles follow them more closely. About `triangles`, half of them the room's: within 7 %
// from 1000 on, within 2 % from 10 000.
Scene clutter(std::size_t triangles);
}
