#include "engine/baked/lightmap.hpp"
#include "engine/core/error.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace afterglow
{
static Lightmap page()
{
    Lightmap page;
    page.width = 8;
    page.height = 4;
    for (int i = 0; i < 32; ++i) {
        const float light = std::exp2(float(i) - 16.0f);
        page.texels.push_back(vec3(light, 0.37f * light, 0.011f * light));
        page.valid.push_back(std::uint8_t(i % 3));
    }
    return page;
}

static Lightmap roundTrip(const Lightmap& page) { return readLightmap(lightmapTexture(page), coverageTexture(page), "test"); }

TEST(Lightmap, is_within_half_a_step_of_the_shared_exponent)
{
    const Lightmap in = page(), out = roundTrip(in);
    ASSERT_EQ(out.texels.size(), in.texels.size());
    for (std::size_t i = 0; i < in.texels.size(); ++i) {
        // Nine bits, the first of them set: the step is 2^-8 of the power of two below the largest channel.
        const float half = in.texels[i].r / 512.0f;
        for (int c = 0; c < 3; ++c) EXPECT_LE(std::abs(out.texels[i][c] - in.texels[i][c]), half) << i;
    }
    EXPECT_EQ(lightmapTexture(in).format, Ktx2Format::rgb9e5);
}

TEST(Lightmap, written_a_second_time_does_not_change)
{
    const Lightmap once = roundTrip(page()), twice = roundTrip(once);
    EXPECT_EQ(once.texels, twice.texels);
}

TEST(Lightmap, keeps_black_and_no_data_apart)
{
    Lightmap in = page();
    for (vec3& texel : in.texels) texel = vec3(0.0f);
    EXPECT_EQ(roundTrip(in).valid, in.valid);
    EXPECT_EQ(roundTrip(page()).valid, page().valid);
}

// H81, H34
TEST(Lightmap, beyond_the_shared_exponent_is_kept_in_floats)
{
    Lightmap in = page();
    in.texels[3] = vec3(1e6f, 2.0f, 0.123456f);
    EXPECT_EQ(lightmapTexture(in).format, Ktx2Format::rgba32f);
    EXPECT_EQ(roundTrip(in).texels, in.texels);
}

// H81: light of 1e-8 is light, as the exposure may say.
TEST(Lightmap, below_the_shared_exponent_is_kept_in_floats)
{
    for (const float scale : {1e-8f, 1e-5f, 2e-5f}) {
        Lightmap in = page();
        for (std::size_t i = 0; i < in.texels.size(); ++i) in.texels[i] = scale * vec3(1.0f, 0.3f, float(i) / 32.0f);
        const Lightmap out = roundTrip(in);
        for (std::size_t i = 0; i < in.texels.size(); ++i)
            for (int c = 0; c < 3; ++c) EXPECT_LE(std::abs(out.texels[i][c] - in.texels[i][c]), scale / 512.0f) << scale << ' ' << i;
    }
    Lightmap dark = page();
    for (vec3& texel : dark.texels) texel = vec3(0.0f);
    EXPECT_EQ(lightmapTexture(dark).format, Ktx2Format::rgb9e5) << "black is black";
}

TEST(Lightmap, on_disk_is_finite_and_not_negative)
{
    Lightmap in = page();
    in.texels[0] = vec3(NAN, -1.0f, 1.0f);
    in.texels[1] = vec3(INFINITY, 1.0f, -INFINITY);
    const Lightmap out = roundTrip(in);
    for (const vec3& texel : out.texels)
        for (int c = 0; c < 3; ++c) EXPECT_TRUE(std::isfinite(texel[c]) && texel[c] >= 0.0f);
    EXPECT_EQ(out.texels[0], vec3(0.0f, 0.0f, 1.0f));
}

TEST(Lightmap, keeps_direction_to_half_a_float)
{
    Lightmap in = page();
    for (std::size_t i = 0; i < in.texels.size(); ++i) in.direction.push_back(vec4(0.37f * float(i), -1.1f, 0.0f, 1.0f - 0.2f * float(i)));
    Lightmap out = roundTrip(in);
    EXPECT_TRUE(out.direction.empty());
    readDirection(directionTexture(in), out, "test");
    ASSERT_EQ(out.direction.size(), in.direction.size());
    for (std::size_t i = 0; i < in.direction.size(); ++i)
        for (int c = 0; c < 4; ++c)
            EXPECT_LE(std::abs(out.direction[i][c] - in.direction[i][c]), std::abs(in.direction[i][c]) / 2048.0f) << i;
    Ktx2 other = directionTexture(in);
    std::swap(other.width, other.height);
    EXPECT_THROW(readDirection(other, out, "test"), Error);
    EXPECT_THROW(readDirection(coverageTexture(in), out, "test"), Error);
}

TEST(Lightmap, with_a_foreign_coverage_is_refused)
{
    Ktx2 coverage = coverageTexture(page());
    coverage.levels[0][0] = 77;
    EXPECT_THROW(readLightmap(lightmapTexture(page()), coverage, "test"), Error);
    EXPECT_THROW(readLightmap(coverageTexture(page()), coverageTexture(page()), "test"), Error);
    Lightmap other = page();
    other.width = 4, other.height = 8;
    EXPECT_THROW(readLightmap(lightmapTexture(page()), coverageTexture(other), "test"), Error);
}
}
