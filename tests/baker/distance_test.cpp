// How far a simplified surface is from what it stands for: by quadrics while it is made, by a tree of triangles when it is judged.
#include "baker/quadric.hpp"
#include "tests/baker/surfaces.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
// reference: area-weighted quadrics of both ends, at the end that stays
TEST(Quadric, AreGarlandAndHeckberts)
{
    auto collapse = [](const Shape& shape, uint from, uint to) {
        Quadric sum;
        for (std::size_t i = 0; i < shape.indices.size(); i += 3) {
            const uint* t = &shape.indices[i];
            Quadric q = triangleQuadric(dvec3(shape.positions[t[0]]), dvec3(shape.positions[t[1]]), dvec3(shape.positions[t[2]]));
            for (uint k = 0; k < 3; ++k)
                if (t[k] == from || t[k] == to) sum = sum + q;
        }
        return sum(dvec3(shape.positions[to]));
    };
    auto tent = [](uint n, float height) {
        Shape shape;
        for (uint i = 0; i < n; ++i) {
            float a = kTurn * float(i) / float(n);
            shape.positions.push_back({std::cos(a), std::sin(a), 0});
            for (uint v : {i, (i + 1) % n, n}) shape.indices.push_back(v);
        }
        shape.positions.push_back({0, 0, height});
        return shape;
    };
    Shape cube{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
               {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7}};
    EXPECT_NEAR(collapse(cube, 0, 1), 0.5, 5e-6);
    EXPECT_NEAR(collapse(cube, 1, 0), 1.0, 1e-5);
    EXPECT_NEAR(collapse(tent(6, 0.5f), 6, 0), 0.9375, 9e-6);
    // Inside a flat region a vertex goes for nothing.
    EXPECT_NEAR(collapse(tent(6, 0.0f), 6, 0), 0.0, 1e-9);
}

// The sphere is farthest from an icosphere over the middles of its faces: 1 - their distance from the centre.
TEST(Distance, OfIcospheresToTheSphere)
{
    const double expected[] = {0.2053455277, 0.06582764104, 0.01775305362};
    for (int level = 0; level < 3; ++level) {
        Scene scene = levelOf(icosphere(level));
        std::vector<Corners> surface = corners(scene, scene.indices);
        DistanceTree tree(surface);
        double largest = 0;
        for (const Corners& t : surface) largest = max(largest, tree(unitNormal(t)));
        EXPECT_NEAR(largest, expected[level], 1e-5 * expected[level]);
    }
}

TEST(Distance, TreeAgreesWithEveryTriangleAlone)
{
    Scene scene = levelOf(bumpySphere(2));
    std::vector<Corners> surface = corners(scene, scene.indices);
    DistanceTree tree(surface);
    for (const dvec3& p : {dvec3(0), dvec3(2, 1, 0), dvec3(0.5, -0.4, 0.9), dvec3(-1, -1, -1)}) {
        double nearest = 1e300;
        for (const Corners& t : surface) nearest = min(nearest, DistanceTree({t})(p));
        EXPECT_DOUBLE_EQ(tree(p), nearest);
    }
}
}
