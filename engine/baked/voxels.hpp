// The level's voxels as a 3D texture, for occlusion by what the screen does not see (engine/scene/voxels.hpp).
#pragma once
#include "engine/baked/baked.hpp"
#include "engine/baked/ktx2.hpp"

namespace afterglow
{
// rgba8. Keys: ag_lower and ag_edge in m, in the level's own coordinates; `origin` is the scene's.
Ktx2 voxelTexture(const VoxelGrid& grid, dvec3 origin = dvec3(0.0));

// Throws Error when the texture is not a voxel grid.
VoxelGrid readVoxels(const Ktx2& texture, const std::string& what, dvec3 origin = dvec3(0.0));
}
