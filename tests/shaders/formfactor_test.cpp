// Shapes as a point sees them: catalogue values, and the catalogue against itself.
#include "shaders/formfactor.h"
#include "tests/shaders/statistics.hpp"

namespace afterglow::test
{
TEST(FormFactor, DiscAndSphere)
{
    expectRelative(discFormFactor(1.0f, 1.0f), 0.5, 1e-5);
    expectRelative(discFormFactor(0.5f, 2.0f), 0.05882352941, 1e-5);
    expectRelative(sphereFormFactor(2.0f, 1.0f), 0.25, 1e-5);
    expectRelative(sphereFormFactor(2.0f, 0.5f), 0.125, 1e-5);
    expectRelative(sphereFormFactor(2.0f, std::cos(80.0f * kPi / 180.0f)), 0.05469581645, 1e-5);
    expectRelative(sphereFormFactor(2.0f, std::cos(100.0f * kPi / 180.0f)), 0.01128377203, 1e-5);
    EXPECT_EQ(sphereFormFactor(2.0f, -1.0f), 0.0f);
    expectRelative(coaxialDiscsFormFactor(1.0f, 1.0f, 1.0f), 0.3819660113, 1e-5);
}

TEST(FormFactor, Rectangles)
{
    expectRelative(parallelRectangleFormFactor(1.0f, 1.0f), 0.138531606, 1e-5);
    expectRelative(parallelRectangleFormFactor(2.0f, 0.5f), 0.1068378783, 1e-5);
    expectRelative(perpendicularRectangleFormFactor(2.0f, 1.5f, 0.7f), 0.1481210376, 1e-5);
    expectRelative(perpendicularRectangleFormFactor(1.0f, 1.0f, 1.0f), 0.055734197, 1e-5);
    expectRelative(opposedRectanglesFormFactor(1.0f, 1.0f, 1.0f), 0.1998248957, 1e-5);
    expectRelative(opposedRectanglesFormFactor(2.0f, 1.0f, 0.5f), 0.508988669, 1e-5);
    expectRelative(adjacentRectanglesFormFactor(1.0f, 1.0f, 1.0f), 0.2000437761, 1e-5);
    expectRelative(adjacentRectanglesFormFactor(2.0f, 1.0f, 0.5f), 0.07865027051, 1e-5);
}

// A box of the Cornell dimensions sees itself: its five other walls sum to 1.
TEST(FormFactor, AClosedBoxSumsToOne)
{
    float x = 552.8f, y = 548.8f, z = 559.2f;
    float ceiling = opposedRectanglesFormFactor(x, z, y), back = adjacentRectanglesFormFactor(z, x, y),
          left = adjacentRectanglesFormFactor(x, z, y);
    expectRelative(ceiling, 0.2032588277, 1e-5);
    expectRelative(back, 0.19801991, 1e-5);
    EXPECT_NEAR(ceiling + 2.0f * back + 2.0f * left, 1.0f, 1e-5f);
}

TEST(FormFactor, TrianglesAreCutAtTheHorizon)
{
    expectRelative(triangleIrradiance(vec3(1, 0, 1), vec3(0, 1, 1), vec3(0, 0, 2), vec3(0, 0, 1)), 0.302299894, 1e-5);
    expectRelative(triangleIrradiance(vec3(2, 0, -0.5f), vec3(-1, 1, 1), vec3(0, -1, 2), vec3(0, 0, 1)), 1.497523848, 1e-5);
    EXPECT_EQ(triangleIrradiance(vec3(1, 0, -1), vec3(0, 1, -1), vec3(0, 0, -2), vec3(0, 0, 1)), 0.0f);
    EXPECT_EQ(triangleIrradiance(vec3(1, 0, 0), vec3(0, 1, 0), vec3(-1, -1, 0), vec3(0, 0, 1)), 0.0f);  // in the plane itself
    EXPECT_NEAR(lambertEdge(vec3(1, 0, 0), normalize(vec3(1, 1e-4f, 0)), vec3(0, 0, 1)), 1e-4f, 1e-9f); // a short edge keeps its digits
}

TEST(FormFactor, CornellLightOnItsFloor)
{
    auto light = [](vec3 p) {
        vec3 a(213, 548.8f, 227), b(343, 548.8f, 227), c(343, 548.8f, 332), d(213, 548.8f, 332);
        return triangleIrradiance(a - p, b - p, c - p, vec3(0, 1, 0)) + triangleIrradiance(a - p, c - p, d - p, vec3(0, 1, 0));
    };
    expectRelative(light(vec3(276.4f, 0, 279.6f)), 0.04463173947, 1e-5);
    expectRelative(light(vec3(100, 0, 400)), 0.03380750343, 1e-5);
}

TEST(FormFactor, SolidAngles)
{
    expectRelative(triangleSolidAngle(vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)), 1.570796327, 1e-5);
    expectRelative(triangleSolidAngle(vec3(1, 0, 1), vec3(0, 1, 1), vec3(0, 0, 2)), 0.3398369095, 1e-5);
    // Small, it is its area
    expectRelative(triangleSolidAngle(vec3(3, 0, 4), vec3(3, 1e-3f, 4), vec3(3 - 8e-4f, 0, 4 + 6e-4f)), 0.5e-6 / 25.0, 1e-3);
}

// What a floor sees of the sky is 1 less what it sees of the shape in the way.
TEST(FormFactor, LeavesTheSkyWhatItDoesNotTake)
{
    // The middle of a square well of half width a and depth h sees its opening
    expectRelative(4.0f * parallelRectangleFormFactor(1.0f, 1.0f), 0.554126424, 1e-5);
    expectRelative(4.0f * parallelRectangleFormFactor(1.0f / 3.0f, 1.0f / 3.0f), 0.1233175894, 1e-5);
    // A wall of height 1 that has no end: two quarters of 1e5 m
    expectRelative(1.0f - 2.0f * perpendicularRectangleFormFactor(1.0f, 1e5f, 1.0f), 0.8535533906, 1e-5);
    expectRelative(1.0f - 2.0f * perpendicularRectangleFormFactor(1.0f, 1e5f, 0.1f), 0.5497518595, 1e-5);
    // A sphere of radius 1 that touches the floor x away: its horizon is the floor's
    for (dvec2 row : {dvec2(1.0, 0.6464466094), dvec2(0.1, 0.01481466316)}) {
        float h = float(std::sqrt(1.0 + row.x * row.x));
        expectRelative(1.0f - sphereFormFactor(h, 1.0f / h), row.y, 1e-5);
    }
}
}
