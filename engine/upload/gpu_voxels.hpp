// The level's voxels in GPU memory: a volume whose mips are their coarser levels.
#pragma once
#include "engine/gpu/gpu.hpp"
#include "engine/scene/voxels.hpp"

namespace afterglow
{
struct GpuVoxels {
    GpuImage image; // RGBA8; absent when the level has nothing that hides
    vec3 lower{0.0f};
    float edge = 0.0f; // m, of a voxel of mip 0
};

GpuVoxels uploadVoxels(Gpu& gpu, const VoxelGrid& grid);
}
