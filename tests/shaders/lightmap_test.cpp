// Packing: shared exponents and halves, at their ends and with what is no number.
#include "shaders/lightmap.h"
#include "tests/shaders/statistics.hpp"
#include <limits>

namespace afterglow::test
{
// H81: 2^-9 of the largest channel, down to the smallest step.
TEST(SharedExponent, ErrsByLessThanAStepOfTheLargestChannel)
{
    Random random;
    for (int i = 0; i < 200000; ++i) {
        float scale = std::exp2(random.next() * 40.0f - 24.0f);
        vec3 c = vec3(random.next(), random.next(), random.next()) * scale;
        vec3 back = decodeSharedExponent(encodeSharedExponent(c));
        float largest = std::max(std::max(c.x, c.y), c.z), step = std::max(largest / 512.0f, std::exp2(-25.0f));
        for (int k = 0; k < 3; ++k)
            ASSERT_LE(std::abs(back[k] - std::min(c[k], kSharedExponentMax)), step * 1.0001f) << c.x << " " << c.y << " " << c.z;
    }
}

// H81
TEST(SharedExponent, ClampsAndSwallows)
{
    const float inf = std::numeric_limits<float>::infinity(), nan = std::nanf("");
    EXPECT_EQ(kSharedExponentMax, 65408.0f);
    for (float x : {65408.0f, 65520.0f, 1e8f, inf}) EXPECT_EQ(decodeSharedExponent(encodeSharedExponent(vec3(x))), vec3(65408.0f));
    for (float x : {0.0f, -1.0f, -inf, nan}) EXPECT_EQ(decodeSharedExponent(encodeSharedExponent(vec3(x))), vec3(0.0f));
    EXPECT_EQ(decodeSharedExponent(encodeSharedExponent(vec3(1e-40f))), vec3(0.0f));
    EXPECT_EQ(decodeSharedExponent(encodeSharedExponent(vec3(1.0f, 0.5f, 0.25f))), vec3(1.0f, 0.5f, 0.25f));
    vec3 wide = decodeSharedExponent(encodeSharedExponent(vec3(65408, 1, 0))); // the weak channel may go, the strong one stays
    EXPECT_EQ(wide.x, 65408.0f);
    EXPECT_LE(std::abs(wide.y - 1.0f), 65408.0f / 512.0f);
}

TEST(SharedExponent, EveryCodeThatWeWriteComesBackAsItself)
{
    for (uint e = 0; e < 32u; ++e)
        for (uint m : {256u, 300u, 511u}) {
            uint packed = m | (m / 2u << 9u) | (7u << 18u) | (e << 27u);
            EXPECT_EQ(encodeSharedExponent(decodeSharedExponent(packed)), packed);
        }
}

// H81: clamped to 65504 first; what is smaller than half of the smallest step is 0.
TEST(Half, RoundsToNearestEven)
{
    auto half = [](float v) { return decodeHalf(encodeHalf(v)); };
    EXPECT_EQ(half(65504.0f), 65504.0f);
    EXPECT_EQ(half(65519.99f), 65504.0f);
    EXPECT_EQ(encodeHalf(65520.0f), 0x7c00u); // infinity: which is why clampToHalf comes first
    EXPECT_EQ(half(clampToHalf(vec3(65520.0f)).x), 65504.0f);
    EXPECT_EQ(half(clampToHalf(vec3(1e8f)).x), 65504.0f);
    EXPECT_EQ(half(1.0f / 3.0f), 0.333251953125f);
    EXPECT_EQ(half(2049.0f), 2048.0f);
    EXPECT_EQ(half(1e-8f), 0.0f);
    EXPECT_EQ(half(6e-8f), 5.960464477539063e-08f);
    EXPECT_EQ(clampToHalf(vec3(std::nanf(""), -1.0f, 2.0f)), vec3(0, 0, 2));
    for (uint code = 0; code < 0x7c00u; ++code) ASSERT_EQ(encodeHalf(decodeHalf(code)), code);
    for (float x = 7e-5f; x < 60000.0f; x *= 1.01f) EXPECT_LE(std::abs(half(x) - x), x * 0.000488282f);
}

TEST(Lightmap, StoredValueTimesPiIsIrradiance)
{
    EXPECT_FLOAT_EQ(irradianceToStored(vec3(kPi)).x, 1.0f);
    EXPECT_FLOAT_EQ(storedToIrradiance(irradianceToStored(vec3(3.7f))).x, 3.7f);
}
}
