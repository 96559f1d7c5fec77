// Bakes to a stated error: where the paths go, and whether what is stated is so.
#include "baker/baker.hpp"
#include "baker/rounds.hpp"
#include "baker/tile_light.hpp"
#include "rooms.hpp"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <iterator>
#include <nlohmann/json.hpp>

namespace afterglow
{
static double errorOf(const std::vector<TileNoise>& tiles, const std::vector<int>& samples)
{
    double noise = 0.0, texels = 0.0;
    for (std::size_t i = 0; i < tiles.size(); i++) {
        noise += double(tiles[i].texels) * tiles[i].variance / samples[i];
        texels += double(tiles[i].texels);
    }
    return std::sqrt(noise / texels);
}

TEST(Rounds, GoWhereTheNoiseIs)
{
    const std::vector<TileNoise> tiles = {{64, 1.0, 16}, {64, 16.0, 16}, {32, 4.0, 16}};
    const double now = errorOf(tiles, {16, 16, 16});
    const std::vector<int> next = nextSamples(tiles, now, 0.7 * now);
    EXPECT_LE(errorOf(tiles, next), 0.7 * now * kAimedShare * 1.01);
    EXPECT_GE(errorOf(tiles, next), 0.6 * now); // and no further
    EXPECT_EQ(next[0], 16);                     // no fewer than it has
    EXPECT_NEAR(double(next[1]) / next[2], 2.0, 0.1);
    for (int samples : next) EXPECT_EQ(samples % 2, 0);

    // As few as that takes: a uniform number of as many paths in all leaves more noise
    const double paths = 64.0 * next[0] + 64.0 * next[1] + 32.0 * next[2];
    const int even = int(paths / 160.0);
    EXPECT_LT(errorOf(tiles, next), errorOf(tiles, {even, even, even}));
}

TEST(Rounds, GrowByStepsAndNeverStandStill)
{
    const std::vector<TileNoise> tiles = {{64, 1.0, 16}, {64, 1.0, 16}};
    const double now = errorOf(tiles, {16, 16});
    const std::vector<int> far = nextSamples(tiles, now, 0.001 * now);
    EXPECT_GE(far[0] + far[1], int(32 * kRoundGrowth));
    EXPECT_LE(far[0] + far[1], int(32 * kRoundGrowth) + 4);
    const std::vector<int> near = nextSamples(tiles, now, 0.9999 * now);
    EXPECT_GT(near[0] + near[1], 32);
    // A tile that has seen nothing is not left at that; one at the limit stays there
    EXPECT_GT(nextSamples({{64, 0.0, 16}, {64, 4.0, 512}}, 1.0, 0.1)[0], 16);
    EXPECT_EQ(nextSamples({{64, 1.0, kMostSamples}}, 1.0, 0.1)[0], kMostSamples);
    // Nor does a level without light, or without texels, go on for ever
    EXPECT_EQ(nextSamples({{64, 0.0, 16}}, 1.0, 0.1)[0], 16);
    EXPECT_TRUE(nextSamples({}, 1.0, 0.1).empty());
}

// Relative RMSE of one bake's texels against another's, where both are baked.
static double apart(const Baked& a, const Baked& b)
{
    double squares = 0.0, total = 0.0;
    for (std::size_t p = 0; p < a.lightmaps.size(); p++)
        for (std::size_t i = 0; i < a.lightmaps[p].texels.size(); i++) {
            if (a.lightmaps[p].valid[i] != 1 || b.lightmaps[p].valid[i] != 1) continue;
            const vec3 d = a.lightmaps[p].texels[i] - b.lightmaps[p].texels[i], mean = b.lightmaps[p].texels[i];
            squares += double(dot(d, d)) / 3.0;
            total += double(mean.x + mean.y + mean.z) / 3.0;
        }
    std::size_t texels = 0;
    for (std::size_t p = 0; p < a.lightmaps.size(); p++)
        for (std::size_t i = 0; i < a.lightmaps[p].texels.size(); i++)
            texels += a.lightmaps[p].valid[i] == 1 && b.lightmaps[p].valid[i] == 1 ? 1u : 0u;
    return std::sqrt(squares / double(texels)) / (total / double(texels));
}

struct Honest {
    const char* level;
    float texelsPerMetre, target = 0.0f;
};

// The longer bake is independent, so that the squares of both errors add up: where one path of a million brings most of the light, as in
// the pool, its own is no smaller than that of the other.
static double without(double apart, const nlohmann::json& longer)
{
    const double own = longer["products"]["lightmaps"]["estimated_error"];
    return std::sqrt(std::max(apart * apart - own * own, 0.0));
}

// What a bake states, with a light cache and without, against a bake of 64 times its paths to their end and another seed: within a fifth.
static void expectHonest(const Honest& asked)
{
    Progress silent(ProgressStyle::none);
    const Scene scene = loadLevel(std::string("content/") + asked.level);
    BakeOptions options;
    options.texelsPerMetre = asked.texelsPerMetre;
    options.denoiser = Denoiser::none;
    options.directAll = true;
    options.probes = options.reflections = options.lods = options.voxels = false;
    options.stitch = false; // what is traced
    options.targetError = asked.target;
    Baked baked[2];
    nlohmann::json said[2], told;
    double most = 0.0; // paths of a texel
    for (const bool cache : {false, true}) {
        options.lightCache = cache;
        options.seed = 3;
        baked[cache] = bakeScene(scene, options, silent, told);
        said[cache] = told["products"]["lightmaps"];
        most = std::max(most, double(said[cache]["samples"]));
    }
    options.targetError.reset();
    options.lightCache = false;
    options.samples = int(64.0 * most);
    options.seed = 1234;
    const Baked longer = bakeScene(scene, options, silent, told);
    for (const bool cache : {false, true}) {
        const double stated = said[cache]["estimated_error"], measured = without(apart(baked[cache], longer), told);
        std::printf("| %s | %s | %.1f | %.3f | %.3f | %.2f |\n", asked.level, cache ? "cache" : "paths", double(said[cache]["samples"]),
                    stated, measured, measured / stated);
        EXPECT_LE(stated, double(asked.target));
        EXPECT_NEAR(measured / stated, 1.0, 0.2) << (cache ? "with a light cache" : "paths alone");
    }
}

// What the filter says that it leaves, against a bake of 64 times its paths without it: within a fifth, and rather too much. Experiment, 4
// to 32 paths, with a light cache and without: 0.83 to 1.11 of what is stated. The pool is left out: there the longer bake is off by more
// than what the filter leaves. Of three seeds the middle one counts: of sixteen bakes of the still life one meets a path so rare that it
// more than doubles what is stated, and leaves with the filter.
static void expectHonestFilter(const char* level, float texelsPerMetre, int samples)
{
    BakeOptions options;
    options.texelsPerMetre = texelsPerMetre;
    options.directAll = true;
    options.stitch = false;
    options.probes = options.reflections = options.lods = options.voxels = false;
    options.samples = samples;
    const Scene scene = loadLevel(std::string("content/") + level);
    Progress silent(ProgressStyle::none);
    nlohmann::json said[3], told;
    Baked baked[3];
    for (std::size_t k = 0; k < 3; ++k) {
        options.seed = 3 + int(k);
        baked[k] = bakeScene(scene, options, silent, told);
        said[k] = told["products"]["lightmaps"];
    }
    options.denoiser = Denoiser::none;
    options.samples = 64 * samples;
    options.seed = 1234;
    const Baked longer = bakeScene(scene, options, silent, told);
    double ratios[3], gains[3];
    for (std::size_t k = 0; k < 3; ++k) {
        const double before = said[k]["estimated_error"], stated = said[k]["filtered_error"],
                     measured = without(apart(baked[k], longer), told);
        ratios[k] = measured / stated, gains[k] = measured / before;
        std::printf("| %s | %d | %.3f | %.3f | %.3f | %.2f |\n", level, samples, before, stated, measured, ratios[k]);
    }
    std::sort(std::begin(ratios), std::end(ratios)), std::sort(std::begin(gains), std::end(gains));
    EXPECT_LT(gains[1], 0.95);
    EXPECT_NEAR(ratios[1], 1.0, 0.2);
    EXPECT_LT(ratios[2], 1.5) << "too little is stated worse than too much";
}

TEST(StatedError, OfWhatIsFilteredOfCornellsBox) { expectHonestFilter("cornell/cornell.glb", 16.0f, 16); }
TEST(StatedError, OfWhatIsFilteredOfAStillLife) { expectHonestFilter("still_life/still_life.glb", 8.0f, 16); }
TEST(StatedError, OfWhatIsFilteredOfTwoRooms) { expectHonestFilter("two_rooms/two_rooms_open.glb", 3.0f, 16); }
TEST(StatedError, OfWhatIsFilteredUnderAHangingCube) { expectHonestFilter("hanging_cube/hanging_cube.glb", 6.0f, 16); }

// Halves of an odd number of paths are not as large; of one path there is no second half, and nothing is stated.
TEST(StatedError, IsThatOfTheMeanForAnyNumberOfPaths)
{
    for (const int paths : {2, 3, 5, 7}) {
        double stated = 0.0, is = 0.0;
        constexpr int kTexels = 200000;
        for (int t = 0; t < kTexels; t++) {
            TexelLight light;
            shared::Sampler random = makeSampler(3u, uint(t));
            for (int i = 0; i < paths; i++) light.half[i % 2] += dvec3(double(next1(random))), light.count[i % 2]++;
            stated += std::pow(light.halfDifference().x, 2.0), is += std::pow(light.mean().x - 0.5, 2.0);
        }
        EXPECT_NEAR(stated / is, 1.0, 0.02) << paths;
    }
    BakeOptions options;
    options.texelsPerMetre = 4.0f;
    options.samples = 1;
    options.probes = options.reflections = options.lods = options.voxels = false;
    Progress silent(ProgressStyle::none);
    nlohmann::json told;
    bakeScene(loadLevel("content/cornell/cornell.glb"), options, silent, told);
    EXPECT_FALSE(told["products"]["lightmaps"].contains("estimated_error"));
    EXPECT_FALSE(told["products"]["lightmaps"].contains("filtered_error"));
}

// Alone under an even sky, every texel of a box is as bright as the sky, whatever other sides lie beside it on the page.
TEST(StatedError, IsNoneOfABoxUnderAnEvenSky)
{
    Progress silent(ProgressStyle::none);
    BakeOptions options;
    options.texelsPerMetre = 3.0f;
    options.samples = 2;
    options.denoiser = Denoiser::none;
    options.probes = options.reflections = options.lods = options.voxels = false;
    Scene scene;
    addSurface(scene, box(vec3(1.0f)), shining(0.0f));
    scene.sky.radiance = vec3(1.0f);
    scene.lower = vec3(-0.5f), scene.upper = vec3(0.5f);
    nlohmann::json told;
    const Baked baked = bakeScene(scene, options, silent, told);
    EXPECT_LT(double(told["products"]["lightmaps"]["estimated_error"]), 1e-6);
    ASSERT_EQ(baked.lightmaps.size(), 1u);
    int texels = 0;
    for (std::size_t i = 0; i < baked.lightmaps[0].texels.size(); i++) {
        if (baked.lightmaps[0].valid[i] != 1) continue;
        EXPECT_NEAR(baked.lightmaps[0].texels[i].y, 1.0f, 1e-5f);
        texels++;
    }
    EXPECT_GE(texels, 6 * 9);
}

TEST(StatedError, IsThatAgainstALongBake) { expectHonest({"cornell/cornell.glb", 6.0f, 0.15f}); }

TEST(StatedError, slowOfWhatIsFilteredOfEveryLevel)
{
    for (const Honest& of : {Honest{"cornell/cornell.glb", 32.0f}, Honest{"two_rooms/two_rooms_open.glb", 8.0f},
                             Honest{"hanging_cube/hanging_cube.glb", 8.0f}, Honest{"still_life/still_life.glb", 16.0f}})
        expectHonestFilter(of.level, of.texelsPerMetre, 32);
}

TEST(StatedError, slowIsThatAgainstALongBakeOfEveryLevel)
{
    for (const Honest& asked :
         {Honest{"cornell/cornell.glb", 8.0f, 0.1f}, Honest{"two_rooms/two_rooms_open.glb", 2.0f, 0.15f},
          Honest{"two_rooms/two_rooms_closed.glb", 2.0f, 0.15f}, Honest{"hanging_cube/hanging_cube.glb", 4.0f, 0.1f},
          Honest{"still_life/still_life.glb", 4.0f, 0.1f}, Honest{"pool/pool.glb", 1.0f, 0.1f}, Honest{"gallery/gallery.glb", 0.5f, 0.1f}})
        expectHonest(asked);
}
}
