// Which meshes are bodies that fog can fill, and by which sides.
#include "engine/scene/convex.hpp"
#include <gtest/gtest.h>

namespace afterglow::test
{
namespace
{
using Corners = std::vector<dvec3>;

Corners triangles(const std::vector<dvec3>& points, const std::vector<int>& indices)
{
    Corners corners;
    for (const int i : indices) corners.push_back(points[std::size_t(i)]);
    return corners;
}

Corners tetrahedron() { return triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2}); }

// Upright, with flat ends: 4 triangles a side.
Corners prism(const std::vector<dvec2>& outline)
{
    Corners corners;
    const std::size_t n = outline.size();
    const auto at = [&](std::size_t i, double y) { return dvec3(outline[i % n].x, y, outline[i % n].y); };
    for (std::size_t i = 0; i < n; ++i) {
        corners.insert(corners.end(), {at(i, 0), at(i + 1, 0), at(i + 1, 2), at(i, 0), at(i + 1, 2), at(i, 2)});
        if (i > 0 && i + 1 < n) corners.insert(corners.end(), {at(0, 0), at(i, 0), at(i + 1, 0), at(0, 2), at(i, 2), at(i + 1, 2)});
    }
    return corners;
}

Corners round(std::size_t sides)
{
    std::vector<dvec2> outline;
    for (std::size_t i = 0; i < sides; ++i) {
        const double angle = 6.283185307179586 * double(i) / double(sides);
        outline.push_back(dvec2(float(std::cos(angle)), float(std::sin(angle)))); // rounded, as a file holds it
    }
    return prism(outline);
}
}

TEST(Convex, CountsSidesNotTriangles)
{
    EXPECT_EQ(convexPlanes(tetrahedron())->size(), 4u);
    EXPECT_EQ(convexPlanes(round(32))->size(), 34u);
    EXPECT_TRUE(convexPlanes(prism({{0, 0}, {0, 3}, {2, 3}, {2, 0}}))->empty()) << "the box around it says it all";
    EXPECT_EQ(convexPlanes(round(4))->size(), 6u) << "a box, but turned";
}

TEST(Convex, SidesLookOutwardsWhateverTheWinding)
{
    Corners flipped = tetrahedron();
    for (std::size_t i = 0; i < flipped.size(); i += 6) std::swap(flipped[i], flipped[i + 1]);
    const auto planes = convexPlanes(flipped);
    ASSERT_TRUE(planes);
    for (const dvec4& plane : *planes) EXPECT_LT(dot(dvec3(plane), dvec3(0.2)), plane.w);
}

TEST(Convex, RefusesWhatIsOpenHollowOrTooFine)
{
    Corners open = tetrahedron();
    open.resize(9);
    EXPECT_FALSE(convexPlanes(open));
    EXPECT_FALSE(convexPlanes(prism({{0, 0}, {0, 2}, {1, 2}, {1, 1}, {2, 1}, {2, 0}}))) << "an L";
    EXPECT_FALSE(convexPlanes(round(63))) << "65 sides";
    EXPECT_TRUE(convexPlanes(round(62)));
    EXPECT_FALSE(convexPlanes({}));
    EXPECT_FALSE(convexPlanes({dvec3(0), dvec3(0), dvec3(0)}));
}
}
