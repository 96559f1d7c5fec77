// Moves the borders between charts until they are short and the charts round and flat: such charts leave less of a page between them.
// This work is based on: variational shape approximation (Cohen-Steiner, Alliez, Desbrun 2004), asked at the borders alone.
#pragma once
#include "baker/atlas_surface.hpp"

namespace afterglow
{
// `neighbours`: as Charts has them. `chartOf`: per triangle, ids from 0; a part that is cut off joins a neighbour, or gets an id of its own.
void moveBorders(const Surface& surface, const std::vector<uint>& neighbours, std::vector<uint>& chartOf);
}
