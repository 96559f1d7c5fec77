#include "engine/upload/gpu_voxels.hpp"
#include <algorithm>

namespace afterglow
{
// A cone is asked no wider than this many levels up.
constexpr uint kVoxelMips = 4;

GpuVoxels uploadVoxels(Gpu& gpu, const VoxelGrid& grid)
{
    if (grid.closed.empty()) return {};
    const ivec3 count = grid.count;
    const uint whole = mipCount(uvec2(uint(std::min({count.x, count.y, count.z}))));
    ImageShape shape{
        .format = VK_FORMAT_R8G8B8A8_UNORM, .size = uvec3(count), .mips = std::min(kVoxelMips, whole), .kind = ImageKind::volume};
    GpuVoxels result{gpu.memory.image("voxels", shape), grid.lower, grid.edge};
    VoxelGrid level = grid;
    for (uint mip = 0; mip < shape.mips; ++mip) {
        gpu.memory.upload(result.image, level.closed.data(), level.closed.size() * sizeof(u8vec4), mip);
        if (mip + 1 < shape.mips) level = coarser(level);
    }
    return result;
}
}
