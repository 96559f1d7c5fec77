// The level as a grid of voxels that say how much of them is closed: what the screen does not see can still be asked there.
#pragma once
#include "engine/scene/scene.hpp"

namespace afterglow
{
// Voxel (i, j, k) fills lower + edge * [i, i + 1] x [j, j + 1] x [k, k + 1]; order: x fastest, then y, then z. `closed`: how much of its
// faces across x, y and z the surfaces within it cover, seen along that axis; 255 = all. A ray through a surface thus meets as much of it
// at any angle, and one along it meets nothing. The fourth is 255. The outermost voxels are empty.
struct VoxelGrid {
    vec3 lower{0.0f};  // world, m
    float edge = 0.0f; // of a voxel, m
    ivec3 count{0};
    std::vector<u8vec4> closed;
};

constexpr std::size_t kMostVoxels = 1 << 20; // 4 MiB

// Of what light does not pass: every opaque or masked surface, or the static ones alone. Empty when there is none.
VoxelGrid voxelize(const Scene& scene, bool staticOnly, std::size_t most = kMostVoxels);

// The next coarser level: edges of two voxels, a face of which is four faces. Of the first four levels none leaves a rest.
VoxelGrid coarser(const VoxelGrid& grid);
}
