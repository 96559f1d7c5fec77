// Convex pieces of space, cut by planes.
#include "baker/region.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
static constexpr double kThin = 1e-6;

// A closed surface: its faces' areas along their normals cancel.
static void expectClosed(const Region& region)
{
    dvec3 sum(0.0);
    for (const Region::Face& face : region.faces) sum += area(face.corners) * face.normal;
    EXPECT_NEAR(length(sum), 0.0, 1e-9);
}

TEST(Region, ofABoxHasItsVolumeAndBounds)
{
    const Region box = boxRegion(dvec3(1, 2, 3), dvec3(2, 4, 6));
    expectClosed(box);
    EXPECT_NEAR(box.volume(), 6.0, 1e-12);
    EXPECT_EQ(box.lower(), dvec3(1, 2, 3));
    EXPECT_EQ(box.upper(), dvec3(2, 4, 6));
    EXPECT_TRUE(box.holds(dvec3(1.5, 3, 4)));
    EXPECT_FALSE(box.holds(dvec3(1.5, 3, 7)));
}

TEST(Region, cutsIntoPartsThatAddUp)
{
    Region rest = boxRegion(dvec3(-1), dvec3(1));
    double sum = 0.0;
    for (const dvec3 normal : {dvec3(1, 0, 0), dvec3(1, 1, 0), dvec3(1, 2, 3), dvec3(-3, 1, 0.1)}) {
        const dvec3 n = normalize(normal);
        const Region part = clipped(rest, n, 0.2, true, kThin);
        rest = clipped(rest, -n, -0.2, true, kThin);
        expectClosed(part);
        expectClosed(rest);
        sum += part.volume();
    }
    EXPECT_NEAR(sum + rest.volume(), 8.0, 1e-9);
}

TEST(Region, knowsWhichFacesAreWalls)
{
    const Region part = clipped(boxRegion(dvec3(0), dvec3(1)), dvec3(1, 0, 0), 0.25, true, kThin);
    EXPECT_EQ(part.faces.size(), 6u);
    for (const Region::Face& face : part.faces) EXPECT_EQ(face.wall, face.normal.x > 0.5);
}

TEST(Region, isEmptyWhereNothingOfItIsLeft)
{
    const Region box = boxRegion(dvec3(0), dvec3(1));
    EXPECT_TRUE(clipped(box, dvec3(1, 0, 0), -0.1, true, kThin).empty());
    EXPECT_TRUE(clipped(box, dvec3(1, 0, 0), 0.5e-6, true, kThin).empty()) << "thinner than asked";
    EXPECT_NEAR(clipped(box, dvec3(1, 0, 0), 2.0, true, kThin).volume(), 1.0, 1e-12);
}

// What touches a region from outside, or lies in its face, is not in it.
TEST(Region, holdsOfAPolygonWhatReachesIn)
{
    const Region box = boxRegion(dvec3(0), dvec3(1));
    const Polygon across = {{-1, -1, 0.5}, {3, -1, 0.5}, {3, 3, 0.5}, {-1, 3, 0.5}};
    EXPECT_NEAR(area(within(box, across, 0.0)), 1.0, 1e-12);
    EXPECT_NEAR(area(within(box, across, 0.1)), 0.64, 1e-12);
    Polygon face = across;
    for (dvec3& corner : face) corner.z = 1.0;
    EXPECT_TRUE(within(box, face, 1e-3).empty());
}
}
