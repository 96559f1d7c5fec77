// The highest density at which a given number of pages suffices.
#pragma once
#include "baker/atlas_unwrap.hpp"

namespace afterglow
{
// What each object of the scene asks of a page: its charts, or the one rectangle of its shared mesh.
std::vector<Footprints> wantedBy(const std::vector<UnwrappedMesh>& meshes, std::size_t objects);

// `count` pages of limits.edge. The meshes are left at the density that was found: one factor on all that is asked.
Pages fill(std::vector<UnwrappedMesh>& meshes, std::size_t objects, int padding, int count, const PageLimits& limits);
}
