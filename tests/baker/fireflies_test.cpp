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
        islands = {std::vector<int>(count, 1), 1};
        for (int x = 0; x < kSide; x++) islands.of[std::size_t(x)] = 2, islands.count = 2; // a row of another
    }
    void add(std::size_t texel, float light, bool oneHalf)
    {
        map.texels[texel] += vec3(light);
        if (oneHalf) guides.half[texel] = vec3(light);
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
    page.add(20 * kSide + 7, 60.0f, true);
    page.add(kSide, 30.0f, true); // at the border of its island
    const double before = page.light(1);
    const std::vector<float> off = spreadFireflies(page.map, page.guides, page.islands);
    EXPECT_NEAR(page.light(1), before, 1e-5 * before);
    EXPECT_EQ(page.map.texels[5], beside);
    for (std::size_t i = kSide; i < page.map.texels.size(); i++)
        ASSERT_NEAR(double(luminance(page.map.texels[i])), before / (kSide * (kSide - 1)), 1e-4) << i;
    EXPECT_NEAR(double(off[1]), kPacket * (60.0 * 60.0 + 30.0 * 30.0) / (before * before), 1e-3 * double(off[1]));
    EXPECT_EQ(off[2], 0.0f);
}

// What both halves have found is there; so is what is bright over a surface, and not in one texel of it.
TEST(Fireflies, AreNotWhatBothHalvesKnow)
{
    Page page;
    page.add(20 * kSide + 7, 60.0f, false);
    const Lightmap before = page.map;
    spreadFireflies(page.map, page.guides, page.islands);
    EXPECT_EQ(page.map.texels, before.texels);
}

// Behind a small window most texels have found nothing yet: the few that have are the light.
TEST(Fireflies, AreNotAllTheLightThereIs)
{
    Page page;
    for (vec3& texel : page.map.texels) texel *= 1e-3f;
    for (std::size_t i = 0; i < page.map.texels.size(); i += 9) page.add(i, 1.0f, true);
    const Lightmap before = page.map;
    spreadFireflies(page.map, page.guides, page.islands);
    EXPECT_EQ(page.map.texels, before.texels);
}
}
