#include "baker/agreement.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace afterglow
{
constexpr double kTarget = 0.05; // steps that may be left

static double difference(double a, double b) { return std::abs(a - b); }

// (a + b) / 2 is to be c, and b is to be d. At first the second counts for next to nothing: with a bright and c black, b comes out negative and
// is held. Once d's say has grown b has to rise, and c with it.
TEST(Agreement, LetsGoOfATexelThatNeedNotBeBlack)
{
    const std::vector<double> measured{1.0, 0.01, 0.0, 1.0};
    const Weighted none{0, 0.0f};
    SeamPatch patch{{0, 1}, {0, 1, 2, 3}, {}};
    patch.side[0] = {{Weighted{0, 0.5f}, {1, 0.5f}, none, none}, {Weighted{1, 1.0f}, none, none, none}};
    patch.side[1] = {{Weighted{2, 1.0f}, none, none, none}, {Weighted{3, 1.0f}, none, none, none}};
    const Asked asked{{0.1, 0.1, 0.1, 0.1}, {0.1, 10.0}};
    const std::vector<double> light = agreed(patch, asked, measured, difference, kTarget);
    EXPECT_LE(difference(0.5 * (light[0] + light[1]), light[2]), kTarget);
    EXPECT_LE(difference(light[1], light[3]), kTarget);
    // Where (a - 1)^2 + (b - 0.01)^2 + c^2 + (d - 1)^2 is least with both agreed, b and d are 1.62 / 4.4.
    EXPECT_NEAR(0.5 * (light[1] + light[3]), 1.62 / 4.4, kTarget);
    for (const double value : light) EXPECT_GE(value, 0.0);
}
}
