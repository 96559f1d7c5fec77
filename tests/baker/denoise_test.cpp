// The filter: it takes noise, leaves edges and other charts alone, and does not ask how large the level is.
#include "again.hpp"
#include "baker/baker.hpp"
#include "baker/denoise.hpp"
#include "shaders/random.h"
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace afterglow
{
static bool everything(vec3, vec3, vec3) { return true; }

static void filter(Lightmap& page, TexelGuides& guides, const Sight& sight = everything)
{
    denoise(page, guides, islandsOf(page, guides, sight), 1);
}

// A number of the standard normal distribution.
static float normal(uint i)
{
    const float u = hashFloat(i), v = hashFloat(i + 77777u);
    return std::sqrt(-2.0f * std::log(1.0f - u)) * std::cos(kTwoPi * v);
}

// A square page of baked texels a metre apart on a floor; `light` of a texel, and half of what its halves differ by, are asked for by its
// column and row.
template <typename Light, typename Half>
static std::pair<Lightmap, TexelGuides> floorPage(int edge, Light light, Half half)
{
    Lightmap page;
    page.width = page.height = edge;
    TexelGuides guides;
    for (int y = 0; y < edge; y++)
        for (int x = 0; x < edge; x++) {
            page.texels.push_back(vec3(light(x, y)));
            page.valid.push_back(1);
            guides.position.push_back(vec3(float(x), 0.0f, float(y)));
            guides.normal.push_back(vec3(0.0f, 1.0f, 0.0f));
            guides.half.push_back(vec3(half(x, y)));
            guides.variance.push_back(0.0f);
        }
    return {page, guides};
}

// A dark half and a bright half with noise on both: the filter takes the noise and leaves the step.
TEST(Denoise, takesNoiseAndLeavesAnEdge)
{
    constexpr int kEdge = 64;
    constexpr float kNoise = 0.1f; // standard deviation
    const auto noisy = [](int x, int y) { return (x < kEdge / 2 ? 0.5f : 3.0f) + kNoise * normal(uint(y * kEdge + x)); };
    auto [page, guides] = floorPage(kEdge, noisy, [](int x, int y) { return kNoise * normal(uint(y * kEdge + x) + 99999u); });
    filter(page, guides);
    double squares = 0.0;
    for (int y = 0; y < kEdge; y++)
        for (int x = 0; x < kEdge; x++) {
            double difference = double(page.texels[std::size_t(y * kEdge + x)].x) - (x < kEdge / 2 ? 0.5 : 3.0);
            squares += difference * difference;
            if (x == kEdge / 2 - 1 || x == kEdge / 2) {
                EXPECT_LT(std::abs(difference), 4.0 * double(kNoise)) << "the edge at row " << y;
            }
        }
    EXPECT_LT(std::sqrt(squares / (kEdge * kEdge)), 0.5 * double(kNoise));
}

// Light that bends as that under a lamp does: what is left of the noise, and what the fits bend, together are under a third of the noise.
TEST(Denoise, leavesSmoothLightAsItBends)
{
    constexpr int kEdge = 64;
    constexpr float kNoise = 0.05f;
    const auto lamp = [](int x, int y) { return 1.0f / std::pow(1.0f + 0.002f * float((x - 20) * (x - 20) + (y - 30) * (y - 30)), 2.0f); };
    auto [page, guides] = floorPage(
        kEdge, [&](int x, int y) { return lamp(x, y) + kNoise * normal(uint(y * kEdge + x)); },
        [](int x, int y) { return kNoise * normal(uint(y * kEdge + x) + 99999u); });
    filter(page, guides);
    double squares = 0.0;
    for (int y = 0; y < kEdge; y++)
        for (int x = 0; x < kEdge; x++) squares += std::pow(double(page.texels[std::size_t(y * kEdge + x)].x - lamp(x, y)), 2.0);
    EXPECT_LT(std::sqrt(squares / (kEdge * kEdge)), 0.33 * double(kNoise));
}

// Two charts side by side on the page and a thousand texels apart in the level, at the scale of a level in metres or far below.
static Lightmap twoCharts(float scale)
{
    constexpr int kEdge = 16;
    auto [page, guides] = floorPage(
        kEdge, [](int x, int y) { return 1.0f + 0.5f * hashFloat(uint(y * kEdge + x)); },
        [](int x, int y) { return 0.14f * normal(uint(y * kEdge + x)); });
    for (vec3& position : guides.position) position = scale * (position + vec3(position.x < float(kEdge / 2) ? 0.0f : 1000.0f, 0.0f, 0.0f));
    filter(page, guides);
    return page;
}

// H11. A power of two scales every length without rounding: nothing else may change a bit.
TEST(Denoise, isTheSameAtEveryScale)
{
    const Lightmap metres = twoCharts(1.0f);
    for (float scale : {0x1p-12f, 0x1p-30f, 0x1p20f}) EXPECT_EQ(twoCharts(scale).texels, metres.texels) << scale;
}

// Black texels beside bright and noisy ones: what a wall parts stays black to the bit, what it does not is filtered.
TEST(Denoise, CarriesNoLightThroughAWall)
{
    constexpr int kEdge = 16;
    for (const bool isWall : {true, false}) {
        const auto isDark = [](int x) { return x < kEdge / 2; };
        auto [page, guides] = floorPage(
            kEdge, [&](int x, int y) { return isDark(x) ? 0.0f : 1.0f + hashFloat(uint(y * kEdge + x)); },
            [&](int x, int y) { return isDark(x) ? 0.0f : normal(uint(y * kEdge + x)); });
        const auto sight = [&](vec3 from, vec3 to, vec3) { return !isWall || (from.x < 7.5f) == (to.x < 7.5f); };
        filter(page, guides, sight);
        EXPECT_EQ(page.texels[5 * kEdge + 7] == vec3(0.0f), isWall);
    }
}

// Two charts that lie side by side on the page and in the level, of one plane: not even between them does light pass.
TEST(Denoise, neverCrossesCharts)
{
    constexpr int kEdge = 24;
    auto [page, guides] = floorPage(
        kEdge, [](int x, int) { return x < kEdge / 2 ? 0.0f : 1.0f; },
        [](int x, int y) { return x < kEdge / 2 ? 0.0f : 0.1f * normal(uint(y * kEdge + x)); });
    for (int y = 0; y < kEdge; y++) page.valid[std::size_t(y * kEdge + kEdge / 2)] = 2;
    const Lightmap before = page;
    filter(page, guides);
    for (int i = 0; i < kEdge * kEdge; i++) EXPECT_NEAR(page.texels[std::size_t(i)].x, before.texels[std::size_t(i)].x, 1e-4f) << i;
}

// One path in 64 of one texel found something a million times as bright as the rest. It is light that is there: the filter spreads it, and
// the page has all of it afterwards.
TEST(Denoise, keepsTheLightOfAFirefly)
{
    constexpr int kEdge = 48;
    constexpr float kPaths = 64.0f, kBright = 1e6f;
    const auto found = [](int x, int y) { return x == 20 && y == 24; };
    auto filled = floorPage(
        kEdge, [&](int x, int y) { return 1.0f + 0.1f * hashFloat(uint(y * kEdge + x)) + (found(x, y) ? kBright / kPaths : 0.0f); },
        [&](int x, int y) { return found(x, y) ? kBright / kPaths : 0.03f * normal(uint(y * kEdge + x)); });
    Lightmap& page = filled.first;
    TexelGuides& guides = filled.second;
    for (int i = 0; i < kEdge * kEdge; i++) page.valid[std::size_t(i)] = i % kEdge < 2 ? 0 : 1;
    const auto sum = [&] {
        double total = 0.0;
        for (const vec3& texel : page.texels) total += double(texel.x);
        return total;
    };
    const double before = sum();
    filter(page, guides);
    EXPECT_NEAR(sum() / before, 1.0, 1e-5);
    EXPECT_LT(page.texels[24 * kEdge + 20].x, 0.1f * kBright / kPaths);
}

// What a bake says of its lightmaps: the filter kept all light, no path was clamped, and those that brought no number are counted.
static nlohmann::json toldOf(float radiance)
{
    Scene scene = halfLitRoom();
    scene.materials[0].emission = vec3(radiance);
    BakeOptions options;
    options.texelsPerMetre = 4.0f;
    options.samples = 16;
    options.probes = options.reflections = options.lods = options.voxels = false;
    return make(scene, options).told["products"]["lightmaps"];
}
TEST(Denoise, isToldWithWhatItKept)
{
    const nlohmann::json bright = toldOf(1e6f), overflowing = toldOf(1e30f);
    EXPECT_NEAR(bright["denoise_kept"].get<double>(), 1.0, 1e-5);
    EXPECT_EQ(bright["paths_clamped"], 0);
    EXPECT_EQ(bright["paths_not_finite"], 0);
    EXPECT_GT(overflowing["paths_not_finite"], 0);
}
}
