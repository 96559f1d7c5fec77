// A small triangle and one of three times its area: points lie on each as often as its area says, and evenly within it.
#include "baker/area.hpp"
#include "tests/baker/shapes.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
TEST(Area, PointsLieUniformOverIt)
{
    Scene scene;
    add(scene, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {8, 0, 0}, {5, 1, 0}}, {0, 1, 2, 3, 4, 5}}, matte(0.5f));
    const World world(scene, Content::staticOnly);
    const Area area(world);
    EXPECT_DOUBLE_EQ(area.whole(), 2.0);
    constexpr int kCount = 20000;
    int near = 0, corner = 0; // on the first triangle; of the second, within the quarter at its first corner
    vec3 sum(0.0f);
    for (uint i = 0; i < kCount; ++i) {
        Sampler random = makeSampler(5u, i);
        const AreaPoint point = area.point(random);
        EXPECT_NEAR(point.corners.x + point.corners.y + point.corners.z, 1.0f, 1e-6f);
        if (point.position.x < 2.0f)
            ++near;
        else
            sum += point.position, corner += point.corners.x > 0.5f;
    }
    const double far = kCount - near, fourSigma = 4.0 * std::sqrt(kCount * 0.25 * 0.75);
    EXPECT_NEAR(near, 0.25 * kCount, fourSigma);
    EXPECT_NEAR(corner, 0.25 * far, 4.0 * std::sqrt(far * 0.25 * 0.75));
    const vec3 mean = sum / float(far); // its centroid, by four deviations: an axis of length L has L / sqrt(18)
    EXPECT_NEAR(mean.x, 6.0, 4.0 * 3.0 / std::sqrt(18.0 * far));
    EXPECT_NEAR(mean.y, 1.0 / 3.0, 4.0 / std::sqrt(18.0 * far));
}

TEST(Area, OfNoSurfaceIsNothing)
{
    Scene line;
    add(line, {{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {0, 1, 2}}, matte(0.5f));
    const World world(line, Content::staticOnly);
    EXPECT_EQ(Area(world).whole(), 0.0);
}
}
