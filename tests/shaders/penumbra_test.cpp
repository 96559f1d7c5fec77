// Soft shadows: the disc light's profile, its width, and the bias of a shadow map.
#include "shaders/penumbra.h"
#include "tests/shaders/statistics.hpp"

namespace afterglow::test
{
TEST(Penumbra, ProfileOfADisc)
{
    EXPECT_EQ(penumbra(-1.0f), 0.0f);
    EXPECT_NEAR(penumbra(-0.5f), 0.1955011095, 1e-6);
    EXPECT_NEAR(penumbra(0.0f), 0.5, 1e-6);
    EXPECT_NEAR(penumbra(0.5f), 0.8044988905, 1e-6);
    EXPECT_NEAR(penumbra(1.0f), 1.0, 1e-6);
    EXPECT_EQ(penumbra(7.0f), 1.0f);
    EXPECT_EQ(penumbra(std::nextafter(1.0f, 2.0f)), 1.0f); // no acos beyond 1
    EXPECT_NEAR(penumbra(0.1f), 0.5635557142, 1e-6);       // ambient occlusion by a wall within reach is the same integral
    float worst = 0.0f;                                    // against the ramp of a box filter
    for (int i = -1000; i <= 1000; ++i) worst = std::max(worst, std::abs(penumbra(float(i) / 1000.0f) - 0.5f - 0.0005f * float(i)));
    expectRelative(worst, 0.0577105, 1e-4);
}

TEST(Penumbra, WidthAndContact)
{
    expectRelative(penumbraWidth(0.5f, 2.0f, 5.0f), 0.75, 1e-6);
    EXPECT_EQ(penumbraWidth(0.5f, 5.0f, 5.0f), 0.0f);
    EXPECT_EQ(penumbraWidth(0.5f, 0.0f, 5.0f), 0.0f); // no blocker
}

TEST(ShadowBias, OneTexelOfSlope)
{
    float slope = std::tan(60.0f * kPi / 180.0f);
    expectRelative(shadowBias(kHalfPi, 1024.0f, 10.0f, slope, 0.0f), 0.01691455867, 1e-4);
    expectRelative(shadowBias(kHalfPi, 1024.0f, 10.0f, slope, 1.0f), 0.050743676, 1e-4);
}
}
