// Rare light before the filter, on pages of one surface.
#include "baker/fireflies.hpp"
#include "baker/lanes.hpp"
#include "shaders/color.h"
#include <gtest/gtest.h>

namespace afterglow
{
namespace
{
constexpr int kSide = 40;

// Of light about 1, of which the halves' noise is a twentieth.
struct Page {
    Lightmap map;
    TexelGuides guides;
    Islands islands;

    Page()
    {
        map.width = map.height = kSide;
        const std::size_t count = std::size_t(kSide) * kSide;
        map.texels.assign(count, vec3(1.0f, 0.5f, 0.25f));
        map.valid.assign(count, 1);
        guides = {std::vector<vec3>(count), std::vector<vec3>(count, vec3(0, 1, 0)), std::vector<vec3>(count, vec3(0.05f)),
                  std::vector<float>(count, 1.0f)};
        map.direction.assign(count, vec4(0.0f, 1.0f, 0.0f, 0.5f));
        islands = {std::vector<int>(count, 1), 1};
        for (int x = 0; x < kSide; x++) islands.of[std::size_t(x)] = 2, islands.count = 2; // a row of another
    }
    void add(std::size_t texel, vec3 light, bool oneHalf)
    {
        map.texels[texel] += light;
        if (oneHalf) guides.half[texel] = light;
        map.direction[texel] = vec4(1.0f, 0.0f, 0.0f, 0.5f);
        guides.variance[texel] = 1e3f;
    }
    double light(int island) const
    {
        double sum = 0.0;
        for (std::size_t i = 0; i < map.texels.size(); i++)
            if (islands.of[i] == island) sum += double(luminance(map.texels[i]));
        return sum;
    }
};
}

TEST(Fireflies, AreSpreadOverTheirIslandAlone)
{
    Page page;
    const vec3 beside = page.map.texels[0];
    page.add(20 * kSide + 7, vec3(20.0f), true);
    page.add(kSide, vec3(15.0f), true);     // at the border of its island
    page.add(kSide + 3, vec3(10.0f), true); // in one square with it
    const double before = page.light(1);
    const std::vector<float> off = spreadFireflies(page.map, page.guides, page.islands);
    EXPECT_NEAR(page.light(1), before, 1e-5 * before);
    EXPECT_EQ(page.map.texels[5], beside);
    for (std::size_t i = kSide; i < page.map.texels.size(); i++) {
        ASSERT_NEAR(double(luminance(page.map.texels[i])), before / (kSide * (kSide - 1)), 1e-4) << i;
        ASSERT_EQ(page.map.direction[i], vec4(0.0f, 1.0f, 0.0f, 0.5f)) << i;
        ASSERT_LT(page.guides.half[i].x, 0.06f) << i;
        ASSERT_LT(page.guides.variance[i], 1.3f) << i;
    }
    EXPECT_NEAR(double(off[1]), (20.0 * 20.0 + 25.0 * 25.0) / (before * before), 1e-3 * double(off[1]));
    EXPECT_EQ(off[2], 0.0f);
}

// What both halves have found is there; so is what is bright over a surface, and not in one texel of it.
TEST(Fireflies, AreNotWhatBothHalvesKnow)
{
    Page page;
    page.add(20 * kSide + 7, vec3(60.0f), false);
    const Lightmap before = page.map;
    spreadFireflies(page.map, page.guides, page.islands);
    EXPECT_EQ(page.map.texels, before.texels);
}

// Texels of a penumbra that half of their paths have met are as many as an edge of light is long.
TEST(Fireflies, AreNotTheEdgeOfAShadow)
{
    Page page;
    for (std::size_t i = 0; i < page.map.texels.size(); i++) {
        const std::size_t x = i % kSide;
        const bool edge = x >= 18 && x <= 20, lit = x > 30; // the light itself is too far off to be the median
        page.map.texels[i] = vec3(lit ? 1.0f : 0.02f);
        page.guides.half[i] = vec3(0.001f);
        if (edge) page.add(i, vec3(0.1f), true);
    }
    const Lightmap before = page.map;
    spreadFireflies(page.map, page.guides, page.islands);
    for (std::size_t y = 7; y < kSide - 7; y++) // where the whole neighbourhood is seen
        for (std::size_t x = 18; x <= 20; x++)
            EXPECT_GT(page.map.texels[y * kSide + x].x, 0.9f * before.texels[y * kSide + x].x) << x << " " << y;
}

// Blue is little of the luminance: where it is most of the blue there is, it stays.
TEST(Fireflies, KeepEveryChannelsLight)
{
    for (const float blue : {0.0f, 0.25f}) {
        Page page;
        for (vec3& texel : page.map.texels) texel.z = blue;
        page.add(20 * kSide + 7, vec3(0.0f, 0.0f, 30.0f), true);
        double before = 0.0, after = 0.0;
        for (const vec3& texel : page.map.texels) before += double(texel.z);
        spreadFireflies(page.map, page.guides, page.islands);
        for (const vec3& texel : page.map.texels) after += double(texel.z);
        EXPECT_NEAR(after, before, 1e-4 * before) << blue;
        EXPECT_EQ(page.map.texels[20 * kSide + 7].z > 15.0f, blue == 0.0f) << blue;
    }
}

// Behind a small window most texels have found nothing yet: the few that have are the light.
TEST(Fireflies, AreNotAllTheLightThereIs)
{
    Page page;
    for (vec3& texel : page.map.texels) texel *= 1e-3f;
    for (std::size_t i = 0; i < page.map.texels.size(); i += 9) page.add(i, vec3(1.0f), true);
    const Lightmap before = page.map;
    spreadFireflies(page.map, page.guides, page.islands);
    EXPECT_EQ(page.map.texels, before.texels);
}
}
