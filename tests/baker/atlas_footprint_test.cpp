#include "baker/atlas_footprint.hpp"
#include "shaders/constants.h"
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace afterglow
{
namespace
{
struct Flat {
    std::vector<dvec2> corners;
    std::vector<uint> rim, sides; // the border's, and all
};

// A band of quads about the origin, from radius 10 to 14, that turns by so much.
Flat band(double turn)
{
    constexpr uint kQuads = 90;
    Flat flat;
    const auto at = [&](uint i, double radius) { return radius * dvec2(std::cos(turn * i / kQuads), std::sin(turn * i / kQuads)); };
    for (uint i = 0; i < kQuads; i++) {
        const dvec2 a = at(i, 10.0), b = at(i, 14.0), c = at(i + 1, 14.0), d = at(i + 1, 10.0);
        flat.corners.insert(flat.corners.end(), {a, b, c, a, c, d});
        flat.rim.insert(flat.rim.end(), {6 * i + 1, 6 * i + 5}); // outside and inside
        if (i == 0) flat.rim.push_back(6 * i);
        if (i + 1 == kQuads) flat.rim.push_back(6 * i + 4);
    }
    flat.sides.resize(flat.corners.size());
    std::iota(flat.sides.begin(), flat.sides.end(), 0u);
    return flat;
}

std::vector<std::uint8_t> texelsOf(const Footprint& footprint)
{
    std::vector<std::uint8_t> taken(std::size_t(footprint.size.x) * std::size_t(footprint.size.y));
    for (const Block& block : footprint.blocks)
        for (int y = 0; y < block.size.y; y++)
            for (int x = 0; x < block.size.x; x++)
                taken[std::size_t(block.lower.y + y) * std::size_t(footprint.size.x) + std::size_t(block.lower.x + x)]++;
    return taken;
}
}
TEST(AtlasFootprint, TellsABandThatMeetsItselfFromOneThatStopsBefore)
{
    const Flat open = band(0.98 * 2.0 * double(kPi)), closed = band(1.02 * 2.0 * double(kPi));
    EXPECT_FALSE(foldsOver(open.corners, open.rim, 0.1));
    EXPECT_TRUE(foldsOver(closed.corners, closed.rim, 0.1));
    EXPECT_FALSE(foldsOver(open.corners, open.sides, 0.1));
    EXPECT_TRUE(foldsOver(closed.corners, closed.sides, 0.1));
}

// Seen from behind, and closed to a ring, whose border is two loops.
TEST(AtlasFootprint, AsksRingsAndWhatIsSeenFromBehind)
{
    Flat ring = band(2.0 * double(kPi)), behind = band(1.02 * 2.0 * double(kPi));
    std::erase_if(ring.rim, [&](uint corner) { return corner == 0 || corner + 2 == ring.corners.size(); }); // where its ends meet
    EXPECT_FALSE(foldsOver(ring.corners, ring.rim, 0.1));
    ivec2 origin;
    const Footprint footprint = afterglow::footprint(ring.corners, ring.rim, 1.0, origin);
    const std::vector<std::uint8_t> taken = texelsOf(footprint);
    const auto at = [&](ivec2 p) { return taken[std::size_t((p.y - origin.y) * footprint.size.x + p.x - origin.x)]; };
    EXPECT_EQ(at(ivec2(0)), 0); // the hole
    EXPECT_EQ(at(ivec2(12, 0)), 1);
    EXPECT_EQ(at(ivec2(-12, 0)), 1);

    for (dvec2& corner : behind.corners) corner.x = -corner.x;
    EXPECT_TRUE(foldsOver(behind.corners, behind.rim, 0.1));
    EXPECT_TRUE(coversTexel(behind.corners, behind.rim));
    ivec2 same;
    EXPECT_EQ(texelsOf(afterglow::footprint(behind.corners, behind.rim, 1.0, origin)),
              texelsOf(afterglow::footprint(behind.corners, behind.sides, 1.0, same)));
}

// Texels of the footprint whose middle is nearer than `margin` to one of many points of the chart, in the larger of x and y.
static std::vector<std::uint8_t> near(const Flat& flat, double margin, ivec2 origin, ivec2 size)
{
    constexpr int kGrid = 40; // of points along a side of a triangle
    std::vector<std::uint8_t> texels(std::size_t(size.x) * std::size_t(size.y));
    for (std::size_t t = 0; t < flat.corners.size(); t += 3)
        for (int i = 0; i <= kGrid; i++)
            for (int j = 0; i + j <= kGrid; j++) {
                const dvec2 u = (flat.corners[t + 1] - flat.corners[t]) * double(i) / double(kGrid),
                            v = (flat.corners[t + 2] - flat.corners[t]) * double(j) / double(kGrid),
                            p = flat.corners[t] + u + v - dvec2(origin) - 0.5;
                const ivec2 low = max(ivec2(floor(p - margin)) + 1, ivec2(0)), high = min(ivec2(ceil(p + margin)), size);
                for (int y = low.y; y < high.y; y++)
                    for (int x = low.x; x < high.x; x++) texels[std::size_t(y) * std::size_t(size.x) + std::size_t(x)] = 1;
            }
    return texels;
}

TEST(AtlasFootprint, HoldsWhatLiesNearTheChart)
{
    const double margin = 1.25, gap = 0.1; // texels; the points are nearer to one another
    for (const Flat& flat : {band(1.0), band(4.0), band(6.2)}) {
        ivec2 origin, same;
        const Footprint footprint = afterglow::footprint(flat.corners, flat.rim, margin, origin);
        const std::vector<std::uint8_t> taken = texelsOf(footprint), least = near(flat, margin, origin, footprint.size),
                                        most = near(flat, margin + gap, origin, footprint.size);
        for (std::size_t i = 0; i < taken.size(); i++) {
            EXPECT_GE(taken[i], least[i]);
            EXPECT_LE(taken[i], most[i]); // and once: blocks are disjoint
        }
        EXPECT_EQ(taken, texelsOf(afterglow::footprint(flat.corners, flat.sides, margin, same)));
        EXPECT_EQ(origin, same);
    }
}
}
