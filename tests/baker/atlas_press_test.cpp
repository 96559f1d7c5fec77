// Footprints pressed into a page: they part where there is room, and it is said where there is none.
#include "baker/atlas_press.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
namespace
{
constexpr int kWide = 40; // texels across a disc

Footprint disc()
{
    std::vector<std::uint8_t> taken(std::size_t(kWide) * kWide);
    for (int y = 0; y < kWide; ++y)
        for (int x = 0; x < kWide; ++x)
            taken[std::size_t(y * kWide + x)] = distance(dvec2(x + 0.5, y + 0.5), dvec2(kWide / 2.0)) < kWide / 2.0;
    return {ivec2(kWide), blocksOf(taken, ivec2(kWide))};
}

std::optional<std::vector<Spot>> pressed(const Footprint& footprint, std::size_t count, ivec2 page)
{
    Patience patience{100000};
    return press(std::vector<const Footprint*>(count, &footprint), std::vector<Spot>(count, Spot{page / 2}), page, patience);
}
}

TEST(AtlasPress, DiscsOnOneHeapSpreadOverThePage)
{
    const Footprint footprint = disc();
    const ivec2 page(3 * kWide + 24); // three by three stand in it, with room to pass
    const std::optional<std::vector<Spot>> spots = pressed(footprint, 9, page);
    ASSERT_TRUE(spots);
    std::vector<int> taken(std::size_t(page.x) * page.y);
    for (const Spot& spot : *spots)
        for (const Block& block : footprint.blocks)
            for (int y = spot.origin.y + block.lower.y; y < spot.origin.y + block.lower.y + block.size.y; ++y)
                for (int x = spot.origin.x + block.lower.x; x < spot.origin.x + block.lower.x + block.size.x; ++x) {
                    ASSERT_TRUE(x >= 0 && y >= 0 && x < page.x && y < page.y);
                    ASSERT_EQ(++taken[std::size_t(y) * page.x + x], 1);
                }
}

TEST(AtlasPress, DiscsLargerThanThePageAreRefused)
{
    EXPECT_FALSE(pressed(disc(), 1, ivec2(kWide - 1, 4 * kWide)));
    EXPECT_FALSE(pressed(disc(), 6, ivec2(2 * kWide))); // of area 6 pi / 4 in one of 4, by their width squared
}
}
