#include "baker/weld.hpp"
#include "tests/baker/shapes.hpp"
#include <gtest/gtest.h>
#include <set>

namespace afterglow
{
namespace
{
std::size_t verticesOf(const Weld& welded) { return std::set(welded.vertex.begin(), welded.vertex.end()).size(); }
}

TEST(Weld, SplitVerticesOfABoxAreEightPoints)
{
    Shape shape = box(vec3(1, 2, 3));
    Weld welded = weld(shape.positions, shape.indices);
    EXPECT_EQ(welded.points, 8u);
    EXPECT_EQ(welded.pointOfVertex.size(), 8u);
    EXPECT_EQ(verticesOf(welded), 8u);
    EXPECT_EQ(welded.partedEdges, 0);
}

TEST(Weld, NegativeZeroIsZero)
{
    Weld welded = weld(std::vector{vec3(0.0f), vec3(-0.0f, 0.0f, -0.0f)}, {});
    EXPECT_EQ(welded.points, 1u);
}

TEST(Weld, SheetsAtAnEdgeOfThreeFacesArePart)
{
    Shape shape = fins(3);
    Weld welded = weld(shape.positions, shape.indices);
    EXPECT_EQ(welded.points, 8u); // two on the axis, two more for each fin
    EXPECT_EQ(welded.partedEdges, 1);
    EXPECT_EQ(verticesOf(welded), 12u); // four for each fin
}

TEST(Weld, AFloorRunsOnUnderTheWallThatStandsOnIt)
{
    Shape shape{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}}, {0, 1, 2, 1, 0, 3, 0, 1, 4}};
    Weld welded = weld(shape.positions, shape.indices);
    EXPECT_EQ(welded.partedEdges, 1);
    EXPECT_EQ(verticesOf(welded), 7u); // four of the floor, three of the wall
}

TEST(Weld, CoincidentSheetsAreTwoWhole)
{
    Shape shape{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {0, 1, 2, 0, 2, 3, 0, 2, 1, 0, 3, 2}};
    Weld welded = weld(shape.positions, shape.indices);
    EXPECT_EQ(verticesOf(welded), 8u);
}

TEST(Weld, TwoConesThatTouchInTheirTipsArePart)
{
    Shape shape{{{0, 0, 0}, {1, 1, 0}, {0, 1, 1}, {-1, 1, 0}, {1, -1, 0}, {0, -1, 1}, {-1, -1, 0}}, {0, 1, 2, 0, 2, 3, 0, 5, 4, 0, 6, 5}};
    Weld welded = weld(shape.positions, shape.indices);
    EXPECT_EQ(welded.points, 7u);
    EXPECT_EQ(verticesOf(welded), 8u); // the tip twice
    EXPECT_EQ(welded.partedEdges, 0);
}

TEST(Weld, AFlippedNeighbourIsAnotherSheet)
{
    Shape shape{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {0, 1, 2, 0, 3, 2}};
    Weld welded = weld(shape.positions, shape.indices);
    EXPECT_EQ(welded.partedEdges, 1);
    EXPECT_EQ(verticesOf(welded), 6u);
}

TEST(Weld, AcrossASideRunsTheOneThatContinuesIt)
{
    const Shape shape = box(vec3(1, 2, 3));
    const Weld welded = weld(shape.positions, shape.indices);
    const auto point = [&](uint corner) { return welded.point[shape.indices[corner]]; };
    const auto next = [](uint corner) { return corner / 3 * 3 + (corner + 1) % 3; };
    for (uint corner = 0; corner < shape.indices.size(); ++corner) {
        const uint across = welded.across[corner];
        ASSERT_NE(across, kNoCorner);
        EXPECT_EQ(welded.across[across], corner);
        EXPECT_EQ(point(across), point(next(corner)));
        EXPECT_EQ(point(next(across)), point(corner));
    }
}
}
