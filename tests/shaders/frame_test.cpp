// Frames, the octahedral map and the ray offset, at their poles and seams.
#include "shaders/frame.h"
#include "tests/shaders/statistics.hpp"
#include <gtest/gtest.h>

namespace afterglow::test
{
TEST(Frame, IsOrthonormalAndRightHandedEverywhere)
{
    Random random;
    for (int i = 0; i < 20000; ++i) {
        vec3 n = i < 2 ? vec3(0, 0, i == 0 ? 1 : -1) : onSphere(2.0 * double(random.next()) - 1.0, 2.0 * M_PI * double(random.next()));
        if (i > 10000) n = normalize(vec3(n.x * 1e-4f, n.y * 1e-4f, n.z < 0.0f ? -1.0f : 1.0f));
        Frame f = makeFrame(n);
        EXPECT_NEAR(dot(f.tangent, f.bitangent), 0.0f, 1e-6f);
        EXPECT_NEAR(dot(f.tangent, n), 0.0f, 1e-6f);
        EXPECT_NEAR(length(f.tangent), 1.0f, 1e-6f);
        EXPECT_NEAR(length(cross(f.tangent, f.bitangent) - n), 0.0f, 2e-6f);
        vec3 v(0.3f, -0.5f, 0.7f);
        EXPECT_NEAR(length(toWorld(f, toLocal(f, v)) - v), 0.0f, 2e-6f);
    }
}

TEST(Frame, FollowsTheTangentItIsGiven)
{
    Frame f = makeTangentFrame(vec3(0, 1, 0), vec4(1, 0.5f, 0, -1));
    EXPECT_NEAR(length(f.tangent - vec3(1, 0, 0)), 0.0f, 1e-6f);
    EXPECT_NEAR(length(f.bitangent - vec3(0, 0, 1)), 0.0f, 1e-6f);
    Frame none = makeTangentFrame(vec3(0, 1, 0), vec4(0, 2, 0, 1)); // A tangent along the normal says nothing
    EXPECT_NEAR(dot(none.tangent, vec3(0, 1, 0)), 0.0f, 1e-6f);
}

TEST(Frame, NormalizesTheTinyAndTheHuge)
{
    for (float scale : {1e-23f, 1e-30f, 1.0f, 1e20f, 1e37f})
        EXPECT_NEAR(length(safeNormalize(vec3(3, 4, 0) * scale, vec3(0)) - vec3(0.6f, 0.8f, 0)), 0.0f, 1e-6f);
    EXPECT_EQ(safeNormalize(vec3(0), vec3(0, 1, 0)), vec3(0, 1, 0));
    EXPECT_EQ(safeNormalize(vec3(std::nanf("")), vec3(0, 1, 0)), vec3(0, 1, 0));
}

TEST(Octahedral, MeetsItsValuesAndComesBack)
{
    auto encode = [](vec3 d) { return octahedralEncode(normalize(d)); };
    EXPECT_NEAR(length(encode(vec3(1, 2, 3)) - vec2(0.5833333333f, 0.6666666667f)), 0.0f, 1e-6f);
    EXPECT_NEAR(length(encode(vec3(1, 2, -3)) - vec2(0.8333333333f, 0.9166666667f)), 0.0f, 1e-6f);
    EXPECT_NEAR(length(encode(vec3(0, 0, -1)) - vec2(1, 1)), 0.0f, 1e-6f);
    Random random;
    for (int i = 0; i < 20000; ++i) {
        vec3 d = onSphere(2.0 * double(random.next()) - 1.0, 2.0 * M_PI * double(random.next()));
        EXPECT_NEAR(length(octahedralDecode(octahedralEncode(d)) - d), 0.0f, 1e-6f);
    }
}

TEST(RayOffset, Is256UlpAndOneSixtyFourThousandthNearTheOrigin)
{
    struct Row {
        float at;
        double ulp, offset;
    };
    for (const Row& r : {Row{1.0f, 1.192092896e-07, 3.051757812e-05}, Row{1000.0f, 6.103515625e-05, 0.015625}, Row{1e6f, 0.0625, 16.0},
                         Row{0.01f, 9.313225746e-10, 1.525878906e-05}}) {
        expectRelative(double(std::nextafter(r.at, kFloatMax)) - double(r.at), r.ulp, 1e-6);
        EXPECT_NEAR(double(offsetRay(vec3(r.at), vec3(1, 0, 0)).x) - double(r.at), r.offset, 1e-6 * r.offset + 1e-9);
        EXPECT_NEAR(double(offsetRay(vec3(-r.at), vec3(-1, 0, 0)).x) + double(r.at), -r.offset, 1e-6 * r.offset + 1e-9);
    }
    EXPECT_EQ(offsetRay(vec3(5.0f), vec3(0, 0, 1)).x, 5.0f);
}

// No integer holds what is not finite, and a step from there ends nowhere: above all not at a point that looks like one.
TEST(Frame, AStepFromNowhereEndsNowhere)
{
    const float infinite = std::numeric_limits<float>::infinity();
    for (const float nowhere :
         {infinite, -infinite, std::numeric_limits<float>::quiet_NaN(), intBitsToFloat(0x7fffffff), intBitsToFloat(-1)})
        for (const float n : {-1.0f, 0.0f, 1.0f}) EXPECT_FALSE(std::isfinite(offsetComponent(nowhere, n))) << nowhere << ' ' << n;
    for (const float p : {-5.0f, 0.0f, 5.0f}) EXPECT_FALSE(std::isfinite(offsetComponent(p, std::numeric_limits<float>::quiet_NaN()))) << p;
}
}
