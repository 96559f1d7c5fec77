// Dilation: light goes where there was none, ring by ring, and nowhere else.
#include "baker/dilate.hpp"
#include "shaders/probe.h"
#include "shaders/random.h"
#include <gtest/gtest.h>

namespace afterglow
{
// An eighth of the texels is baked.
static Lightmap spotted(int width, int height)
{
    Lightmap page;
    page.width = width, page.height = height;
    for (int i = 0; i < width * height; i++) {
        page.valid.push_back(hashFloat(uint(i)) < 0.125f ? 1 : 0);
        page.texels.push_back(page.valid.back() ? vec3(hashFloat(uint(i) + 7u), hashFloat(uint(i) + 99u), 1.0f) : vec3(0.0f));
    }
    return page;
}

static std::vector<uint> nobody(const Lightmap& page) { return std::vector<uint>(page.texels.size(), kNobody); }

TEST(Dilate, neverChangesABakedTexel)
{
    const Lightmap before = spotted(37, 23);
    Lightmap page = before;
    dilate(page, nobody(page));
    for (std::size_t i = 0; i < page.texels.size(); i++) {
        EXPECT_EQ(page.valid[i] == 1, before.valid[i] == 1) << i;
        if (before.valid[i] == 1) {
            EXPECT_EQ(page.texels[i], before.texels[i]) << i;
        }
    }
}

// One baked texel in the middle: its light reaches as many rings as there are, corners included, and its value does not change on the way.
TEST(Dilate, reachesAsFarAsItsRings)
{
    for (int rings : {0, 1, 4}) {
        Lightmap page;
        page.width = page.height = 15;
        page.texels.assign(225, vec3(0.0f));
        page.valid.assign(225, 0);
        page.texels[7 * 15 + 7] = vec3(0.5f, 0.25f, 4.0f);
        page.valid[7 * 15 + 7] = 1;
        dilate(page, nobody(page), rings);
        for (int y = 0; y < 15; y++)
            for (int x = 0; x < 15; x++) {
                const int away = max(abs(x - 7), abs(y - 7));
                const std::size_t here = std::size_t(y * 15 + x);
                EXPECT_EQ(int(page.valid[here]), away == 0 ? 1 : away <= rings ? 2 : 0);
                EXPECT_EQ(page.texels[here], away <= rings ? vec3(0.5f, 0.25f, 4.0f) : vec3(0.0f));
            }
    }
}

// What is filled in a ring is not yet a neighbour in the same ring: the order of the texels does not matter.
TEST(Dilate, fillsWithTheMeanOfTheRingBefore)
{
    Lightmap page;
    page.width = 4, page.height = 1;
    page.texels = {vec3(1.0f), vec3(0.0f), vec3(0.0f), vec3(3.0f)};
    page.valid = {1, 0, 0, 1};
    dilate(page, nobody(page), 1);
    EXPECT_EQ(page.texels[1], vec3(1.0f));
    EXPECT_EQ(page.texels[2], vec3(3.0f));

    page.width = 3;
    page.texels = {vec3(1.0f), vec3(0.0f), vec3(3.0f)};
    page.valid = {1, 0, 1};
    dilate(page, nobody(page), 1);
    EXPECT_EQ(page.texels[1], vec3(2.0f));
}

// A bright chart and a dark one a texel apart, and a gutter of each between them; then a texel of nobody, and a chart without light.
TEST(Dilate, KeepsToTheChart)
{
    Lightmap page;
    page.width = 9, page.height = 1;
    page.texels.assign(9, vec3(0.0f));
    page.valid = {0, 0, 1, 0, 1, 0, 0, 0, 0};
    page.texels[2] = vec3(1.0f);
    dilate(page, {7, 7, 7, 8, 8, 8, kNobody, kNobody, 9}, 1);
    EXPECT_EQ(page.texels[0], vec3(1.0f)); // as many rings as it takes
    EXPECT_EQ(page.texels[3], vec3(0.0f));
    EXPECT_EQ(page.valid, (std::vector<std::uint8_t>{2, 2, 1, 2, 1, 2, 0, 0, 0}));
}
}
