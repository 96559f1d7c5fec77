#include "engine/baked/voxels.hpp"
#include "engine/baked/texels.hpp"
#include "engine/core/error.hpp"
#include "engine/scene/origin.hpp"

namespace afterglow
{
Ktx2 voxelTexture(const VoxelGrid& grid, dvec3 origin)
{
    Ktx2 texture;
    texture.format = Ktx2Format::rgba8;
    texture.width = grid.count.x;
    texture.height = grid.count.y;
    texture.depth = grid.count.z;
    std::vector<std::uint8_t>& bytes = texture.levels.emplace_back();
    for (const u8vec4& closed : grid.closed)
        for (int c = 0; c < 4; ++c) bytes.push_back(closed[c]);
    const dvec3 lower = toLevel(grid.lower, origin);
    texture.keys["ag_lower"] = numbersText(std::vector<double>{lower.x, lower.y, lower.z});
    texture.keys["ag_edge"] = numbersText(std::vector<double>{double(grid.edge)});
    texture.keys["ag_quantity"] = "how much of a voxel's faces across x, y and z the surfaces within it cover, 255 = all";
    return texture;
}

VoxelGrid readVoxels(const Ktx2& texture, const std::string& what, dvec3 origin)
{
    if (texture.format != Ktx2Format::rgba8 || texture.depth == 0 || texture.faces != 1 || texture.layers != 0)
        throw Error("cannot read " + what + ": it is not a voxel grid");
    VoxelGrid grid;
    const std::vector<double> lower = readNumbersText(texture, "ag_lower", 3, what);
    grid.lower = fromLevel(dvec3(lower[0], lower[1], lower[2]), origin);
    grid.edge = float(readNumbersText(texture, "ag_edge", 1, what)[0]);
    if (!(grid.edge > 0.0f)) throw Error("cannot read " + what + ": its voxels have no size");
    grid.count = ivec3(texture.width, texture.height, texture.depth);
    const std::vector<std::uint8_t>& bytes = texture.levels[0];
    for (std::size_t i = 0; i + 3 < bytes.size(); i += 4) grid.closed.emplace_back(bytes[i], bytes[i + 1], bytes[i + 2], bytes[i + 3]);
    return grid;
}
}
