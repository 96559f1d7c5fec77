// Two organisations, the same paths: a wave of them against one after the other, pixel by pixel.
#include "baker/baker.hpp"
#include "engine/core/interrupt.hpp"
#include "engine/scene/scene.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace afterglow
{
// Levels with lamps, emitters, a sky, fog, masks, clear glass and portals.
class Waves : public testing::TestWithParam<const char*>
{
};

TEST_P(Waves, TraceThePathsOfTheLoop)
{
    constexpr double kRounding =
        1e-3; // of a pixel's value, after many vertices: the compiler fuses products and sums as it likes in each form
    constexpr int kWide = 40, kHigh = 24;
    const Scene scene = loadLevel(std::string("content/") + GetParam() + ".glb");
    TruthOptions options;
    options.camera = findCamera(scene, "");
    options.size = ivec2(kWide, kHigh); // no multiple of a tile
    options.samples = 18;               // nor of what a wave holds of a pixel
    Progress silent(ProgressStyle::none);
    const Image loop = truth(scene, options, silent);
    options.organisation = Organisation::wavefront;
    const Image waves = truth(scene, options, silent);
    int differ = 0;
    for (int y = 0; y < kHigh; y++)
        for (int x = 0; x < kWide; x++) {
            bool same = true;
            for (int c = 0; c < 3; c++) {
                const double expected = double(loop.at(x, y)[c]), met = double(waves.at(x, y)[c]);
                ASSERT_TRUE(std::isfinite(met)) << x << ' ' << y;
                same = same && std::abs(met - expected) <= kRounding * expected;
            }
            differ += same ? 0 : 1;
        }
    // A packet may find the other one of two triangles that meet at an edge, or another lot for a blended one: such a path goes elsewhere
    const double samePaths = std::pow(1.0 - differ / double(kWide * kHigh), 1.0 / options.samples);
    EXPECT_GT(samePaths, 0.9995);
}

INSTANTIATE_TEST_SUITE_P(OfLevels, Waves, testing::Values("cornell/cornell", "two_rooms/two_rooms_open", "gallery/gallery", "pool/pool"),
                         [](const auto& info) { return std::string(info.param).substr(0, std::string(info.param).find('/')); });

TEST(WavesOfManyThreads, AreTheSameBits)
{
    const Scene scene = loadLevel("content/cornell/cornell.glb");
    TruthOptions options;
    options.camera = findCamera(scene, "");
    options.size = ivec2(48, 48);
    options.samples = 5;
    options.organisation = Organisation::wavefront;
    Progress silent(ProgressStyle::none);
    options.threads = 1;
    const Image one = truth(scene, options, silent);
    options.threads = 3;
    EXPECT_EQ(truth(scene, options, silent).pixels, one.pixels);
}
}
