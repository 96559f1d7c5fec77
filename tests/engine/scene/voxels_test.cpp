// Voxels: where the surfaces are, how much they close, and what is no surface.
#include "engine/scene/voxels.hpp"
#include "tests/engine/upload/toy_level.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
static int closedAt(const VoxelGrid& grid, vec3 place)
{
    const ivec3 p((place - grid.lower) / grid.edge);
    const u8vec4 closed =
        grid.closed[(std::size_t(p.z) * std::size_t(grid.count.y) + std::size_t(p.y)) * std::size_t(grid.count.x) + std::size_t(p.x)];
    return std::max({int(closed.x), int(closed.y), int(closed.z)});
}

// Area in m2 of surfaces that lie square.
static double areaOf(const VoxelGrid& grid)
{
    double sum = 0.0;
    for (const u8vec4& closed : grid.closed) sum += double(closed.x) + double(closed.y) + double(closed.z);
    return sum / 255.0 * double(grid.edge) * double(grid.edge);
}

TEST(Voxels, OfNothingAreNone)
{
    Scene scene;
    EXPECT_TRUE(voxelize(scene, false).closed.empty());
    Material glass = matte(vec3(1)), veil = matte(vec3(1));
    glass.transmission = 1.0f;
    veil.flags |= kMaterialAlphaBlend;
    addQuad(scene, vec3(0), vec3(1, 0, 0), vec3(0, 1, 0), addMaterial(scene, glass));
    addQuad(scene, vec3(0), vec3(1, 0, 0), vec3(0, 1, 0), addMaterial(scene, veil));
    EXPECT_TRUE(voxelize(scene, false).closed.empty()) << "light passes";
}

// No voxel holds more than a face of a surface that lies square: the areas add up, wherever the surface lies between the voxels.
TEST(Voxels, HoldTheAreaOfASquareSurface)
{
    for (const float height : {0.0f, 0.37f}) {
        Scene scene;
        addQuad(scene, vec3(-2, height, -1), vec3(0, 0, 2), vec3(4, 0, 0), addMaterial(scene, matte(vec3(1))));
        addQuad(scene, vec3(-2, 3, -1), vec3(0, 0, 2), vec3(4, 0, 0), 0);
        const VoxelGrid grid = voxelize(scene, false, 20000);
        EXPECT_NEAR(areaOf(grid), 16.0, 0.05);
        EXPECT_EQ(closedAt(grid, vec3(0.1f, height, 0.1f)), 255);
        EXPECT_EQ(closedAt(grid, vec3(0.1f, 0.5f * (height + 3.0f), 0.1f)), 0);
    }
}

TEST(Voxels, AreAsManyAsAllowedAndEmptyAround)
{
    Scene scene;
    addRoom(scene, vec3(-2, 0, -3), vec3(2, 2.5f, 3), addMaterial(scene, matte(vec3(1))));
    for (const std::size_t most : {std::size_t(1000), std::size_t(100000)}) {
        const VoxelGrid grid = voxelize(scene, false, most);
        EXPECT_NEAR(std::pow(double(grid.edge), 3) * double(most), 4 * 2.5 * 6, 0.01) << "inside of the border";
        for (int z = 0; z < grid.count.z; ++z)
            for (int y = 0; y < grid.count.y; ++y)
                for (int x = 0; x < grid.count.x; ++x) {
                    const ivec3 p(x, y, z);
                    const bool border = any(equal(p, ivec3(0))) || any(equal(p, grid.count - 1));
                    EXPECT_TRUE(!border || closedAt(grid, grid.lower + (vec3(p) + 0.5f) * grid.edge) == 0);
                }
    }
}

// A coarser voxel has four times the face, so that a wall closes it as it did.
TEST(Voxels, CoarserOnesAreClosedByTheSameWall)
{
    Scene scene;
    addQuad(scene, vec3(-4, -4, 0.1f), vec3(8, 0, 0), vec3(0, 8, 0), addMaterial(scene, matte(vec3(1))));
    addQuad(scene, vec3(-4, -4, 8), vec3(8, 0, 0), vec3(0, 8, 0), 0);
    VoxelGrid grid = voxelize(scene, false, 30000);
    for (int level = 0; level < 2; ++level) {
        EXPECT_EQ(closedAt(grid, vec3(0, 0, 0.1f)), 255) << level;
        const VoxelGrid next = coarser(grid);
        EXPECT_FLOAT_EQ(next.edge, 2.0f * grid.edge);
        EXPECT_EQ(next.count, grid.count / 2);
        grid = next;
    }
}

TEST(Voxels, OfWhatStandsStillLeaveOutWhatMoves)
{
    Scene scene;
    addQuad(scene, vec3(0), vec3(0, 0, 4), vec3(4, 0, 0), addMaterial(scene, matte(vec3(1))));
    addQuad(scene, vec3(0, 2, 0), vec3(0, 0, 1), vec3(1, 0, 0), 0).isStatic = false;
    EXPECT_NEAR(areaOf(voxelize(scene, true, 4096)), 16.0, 0.1);
    EXPECT_NEAR(areaOf(voxelize(scene, false, 4096)), 17.0, 0.1);
}
}
