// The sky as a light: directions are drawn by its brightness, and the density says by how much.
#include "baker/sky.hpp"
#include "tests/shaders/statistics.hpp"

namespace afterglow::test
{
namespace
{
// 8 x 8 texels of any brightness, a black row and a small sun among them.
Sky painted()
{
    Sky sky;
    sky.radiance = vec3(1.0f);
    sky.image = Image(8, 8, 3);
    Random random;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            for (int c = 0; c < 3; ++c) sky.image.at(x, y)[c] = y == 5 ? 0.0f : (x == 2 && y == 1 ? 40.0f : random.next());
    return sky;
}
}

TEST(Sky, SamplesFollowTheirDensity)
{
    const Sky sky = painted();
    const SkyLight light(sky);
    auto upright = [](vec3 d) { return vec3(d.x, d.z, d.y); }; // the statistic's pole is +z, the sky's +y
    EXPECT_NEAR(overSphere([&](vec3 d) { return double(light.pdf(upright(d))); }, -1.0, 1.0, 40000, 16), 1.0, 1e-3);
    double deviation = directionChiSquare(
        [&](Random& r, vec3& d) {
            LightSample s = light.sample(r.next2());
            EXPECT_NEAR(s.pdf, light.pdf(s.direction), 1e-5f * s.pdf);
            d = upright(s.direction);
            return true;
        },
        [&](vec3 d) { return double(light.pdf(upright(d))); });
    EXPECT_LT(deviation, 4.0);
}

// H41, H50: to the very poles, where a texel's row shrinks to nothing.
TEST(Sky, TheEndsOfTheUnitIntervalAreSafe)
{
    const Sky sky = painted();
    const SkyLight light(sky);
    for (float x : {0.0f, 0.5f, kOneMinusEpsilon})
        for (float y : {0.0f, 0.5f, kOneMinusEpsilon}) {
            const LightSample s = light.sample(vec2(x, y));
            EXPECT_NEAR(length(s.direction), 1.0f, 1e-6f);
            EXPECT_GT(s.pdf, 0.0f) << x << ' ' << y;
            EXPECT_TRUE(std::isfinite(s.radiance.x / s.pdf)) << x << ' ' << y;
        }
}

TEST(Sky, WithoutAnImageIsLeftToTheSurfaces)
{
    Sky sky;
    sky.radiance = vec3(2.0f);
    const SkyLight light(sky);
    EXPECT_EQ(light.sample(vec2(0.3f)).pdf, 0.0f);
    EXPECT_EQ(light.pdf(vec3(0, 1, 0)), 0.0f);
    EXPECT_EQ(light.radiance(vec3(0, 1, 0)), vec3(2.0f));
}
}
