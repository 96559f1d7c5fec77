// What fits a time: by a pace made by hand, and that what is chosen can be said again, on any number of threads.
#include "baker/pace.hpp"
#include "engine/core/file.hpp"
#include "engine/scene/scene.hpp"
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>

namespace afterglow
{
static BakeOptions quality(Quality name, float density, int samples, float spacing)
{
    return {.quality = name,
            .texelsPerMetre = density,
            .samples = samples,
            .bounces = 64,
            .probeSpacing = spacing,
            .probeSamples = 100,
            .reflectionSize = 10,
            .reflectionSamples = 10};
}
static const std::vector<BakeOptions> kFinest = {quality(Quality::high, 4.0f, 400, 1.0f), quality(Quality::medium, 2.0f, 200, 1.0f),
                                                 quality(Quality::draft, 1.0f, 100, 2.0f)};

// One second whatever is asked for; a hundred texels at 1 a metre, 1 ms and 0.1 ms a path; 8 probes at 1 m and two cubemaps, 1 ms a path.
static const Pace kPace = {1.0, 1e-3, 1e-4, 0.0, 1e-3, 0.0, 1e-3, 100.0, 8.0, 2.0, 0.0, {}};

TEST(Pace, adds_up_what_is_baked)
{
    // 1600 texels of 400 paths; 8 probes of 100; 2 cubemaps of 100 texels and 10 paths
    EXPECT_NEAR(secondsOf(kPace, kFinest[0]), 1.0 + 1600 * (1e-3 + 0.04) + 0.8 + 2.0, 1e-6);
    EXPECT_NEAR(secondsOf(kPace, kFinest[2]), 1.0 + 100 * (1e-3 + 0.01) + 0.1 + 2.0, 1e-6) << "an eighth of the probes";
    BakeOptions lightmaps = kFinest[2];
    lightmaps.probes = lightmaps.reflections = false;
    EXPECT_NEAR(secondsOf(kPace, lightmaps), 1.0 + 1.1, 1e-6);

    // Probes that err by 0.4 are cut until they err by 0.1: half as far apart, eight times as many
    Pace cut = kPace;
    cut.between = 0.4;
    BakeOptions probes = kFinest[0];
    probes.lightmaps = probes.reflections = false;
    probes.probeError = 0.1f;
    EXPECT_NEAR(secondsOf(cut, probes), 1.0 + 8 * 0.8, 1e-6);
    probes.probeError = 0.5f;
    EXPECT_NEAR(secondsOf(cut, probes), 1.0 + 0.8, 1e-6);

    // Noise that asks for four times the paths of a probe, and not of its tests
    Pace noisy = kPace;
    noisy.noise = 1.0;
    probes.probeNoise = 0.05f;
    EXPECT_NEAR(secondsOf(noisy, probes), 1.0 + 8e-3 * (400 + 2.5 * 100) / 3.5, 1e-5);
    noisy.noise = 100.0;
    EXPECT_NEAR(secondsOf(noisy, probes), 1.0 + 8e-3 * (3200 + 2.5 * 100) / 3.5, 1e-5) << "no probe has more";

    // What does not go by paths: blurring cubemaps
    Pace blurred = kPace;
    blurred.reflection = 0.01;
    EXPECT_NEAR(secondsOf(blurred, kFinest[2]) - secondsOf(kPace, kFinest[2]), 2.0, 1e-6);
}

TEST(Pace, takes_the_finest_quality_with_a_quarter_of_its_paths)
{
    const auto choice = [](double seconds) {
        const Paced paced = within(kPace, kFinest, seconds);
        EXPECT_TRUE(paced.fits) << seconds;
        EXPECT_LE(paced.seconds, seconds * (1.0 + 1e-6));
        EXPECT_NEAR(paced.seconds, secondsOf(kPace, paced.options), 1e-9);
        return paced.options;
    };
    EXPECT_EQ(choice(1e6).quality, Quality::high);
    EXPECT_EQ(choice(1e6).samples, 400) << "and no more than it asks for";
    // High without a path takes 5.4 s, each path of all texels 0.16 s
    EXPECT_EQ(choice(5.4 + 0.16 * 100 + 0.01).quality, Quality::high);
    EXPECT_EQ(choice(5.4 + 0.16 * 100 + 0.01).samples, 100);
    EXPECT_EQ(choice(5.4 + 0.16 * 100 - 0.01).quality, Quality::medium);
    EXPECT_EQ(choice(5.4 + 0.16 * 100 - 0.01).samples, 400) << "what a quality leaves over goes to paths, as many as the finest has";
    // Medium with a quarter of its paths takes 4.2 + 0.04 * 50 s
    EXPECT_EQ(choice(3.2 + 0.01 * 290 + 0.001).quality, Quality::draft);
    EXPECT_EQ(choice(3.2 + 0.01 * 290 + 0.001).samples, 290);
    EXPECT_EQ(choice(3.2 + 0.01 * 30 + 0.001).quality, Quality::draft);
    EXPECT_EQ(choice(3.2 + 0.01 * 30 + 0.001).samples, 30);
    // A draft with a quarter of its paths takes 3.1 + 0.35 s: below, its texels become fewer
    const BakeOptions coarse = choice(3.1 + 0.35 / 4.0);
    EXPECT_EQ(coarse.samples, 25);
    EXPECT_NEAR(*coarse.texelsPerMetre, 0.5f, 1e-4f);
}

// High in 25 s: 100 paths at 4 texels a metre, 400 at 2. What is off more by the one is given the other.
TEST(Pace, gives_the_time_to_what_is_off_more)
{
    const auto choice = [](PaceError error) {
        Pace pace = kPace;
        pace.error = error;
        const Paced paced = within(pace, kFinest, 25.0);
        EXPECT_TRUE(paced.fits);
        EXPECT_LE(paced.seconds, 25.0);
        for (float density = 4.0f; density > 0.5f; density *= 0.9f) { // nothing beside it is better
            BakeOptions other = kFinest[0];
            other.texelsPerMetre = density;
            for (other.samples = 100; *other.samples <= 400; *other.samples += 5)
                if (secondsOf(pace, other) <= 25.0) {
                    EXPECT_GE(errorOf(error, other), 0.97 * errorOf(error, paced.options)) << density;
                }
        }
        return paced.options;
    };
    EXPECT_EQ(*choice({0.001, 1.0}).texelsPerMetre, 4.0f);
    EXPECT_EQ(choice({1.0, 0.001}).samples, 400);
    EXPECT_LT(*choice({1.0, 0.001}).texelsPerMetre, 2.2f);
    const BakeOptions both = choice({1.0, 0.2});
    EXPECT_LT(*both.texelsPerMetre, 4.0f);
    EXPECT_GT(*both.texelsPerMetre, 2.2f);
}

// A draft beside probes for which no finer quality has time: its lightmaps are as good as the rest of the time makes them.
TEST(Pace, leaves_no_time_over_that_lightmaps_can_use)
{
    Pace pace = kPace;
    pace.error = {1.0, 0.2};
    std::vector<BakeOptions> finest = kFinest;
    for (BakeOptions& options : finest)
        if (options.quality != Quality::draft) options.probeSpacing = 0.1f; // 1000 times as many
    const Paced paced = within(pace, finest, 25.0);
    EXPECT_EQ(paced.options.quality, Quality::draft);
    EXPECT_GT(paced.seconds, 20.0);
    EXPECT_LE(paced.seconds, 25.0);
    EXPECT_LT(errorOf(pace.error, paced.options), 0.5 * errorOf(pace.error, finest.back()));
}

// What three trials say of a bake that none of them is, held against bakes of many paths and many texels.
TEST(Pace, foretells_the_error_of_another_bake)
{
    Progress silent(ProgressStyle::none);
    const Scene scene = loadLevel("content/cornell/cornell.glb");
    const auto bake = [&](float density, int samples, uint seed) {
        BakeOptions options{.texelsPerMetre = density, .samples = samples, .seed = seed, .directAll = true};
        options.probes = options.reflections = options.lods = options.voxels = false;
        options.denoiser = Denoiser::none;
        nlohmann::json untold;
        return TrialBake{bakeScene(scene, resolved(options, scene), silent, untold), samples, density};
    };
    const PaceError told = paceError(bake(8, 2, 1), bake(8, 10, 2), bake(4, 10, 2), bake(2, 10, 2));
    const TrialBake truth = bake(48, 64, 2);
    for (const auto& [density, samples] : {std::pair(16.0f, 4), std::pair(8.0f, 40), std::pair(4.0f, 80)}) {
        const double off = paceDifference(bake(density, samples, 3).baked, truth.baked);
        BakeOptions options{.texelsPerMetre = density, .samples = samples};
        std::printf("%g texels a metre, %d paths: off by %.3f, foretold %.3f\n", double(density), samples, off, errorOf(told, options));
        EXPECT_LT(errorOf(told, options), 1.5 * off);
        EXPECT_GT(errorOf(told, options), off / 1.5);
    }
}

TEST(Pace, says_when_nothing_fits)
{
    const Paced paced = within(kPace, kFinest, 2.0);
    EXPECT_FALSE(paced.fits);
    EXPECT_EQ(paced.options.quality, Quality::draft);
    EXPECT_EQ(paced.options.samples, 25);
    EXPECT_NEAR(*paced.options.texelsPerMetre, 0.125f, 1e-6f) << "a 64th of the texels";
}

// Whatever the clock said: the words that it printed make the same files.
TEST(Pace, chooses_what_can_be_said_again)
{
    Progress silent(ProgressStyle::none);
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "pace_test";
    std::filesystem::remove_all(folder);
    BakeOptions asked{.quality = Quality::draft};
    asked.timeBudget = 0.001, asked.threads = 2; // nothing fits: quick
    bakeLevel("content/truth/furnace.glb", folder / "paced", asked, silent);
    const nlohmann::json manifest = nlohmann::json::parse(readText(folder / "paced" / "bake.json"));
    EXPECT_FALSE(manifest["time_budget"]["fits"].get<bool>());
    const std::string words = manifest["time_budget"]["chosen"];
    const int fewest = samplesOf(Quality::draft) / 4;
    EXPECT_EQ(words.rfind("--quality draft --samples " + std::to_string(fewest) + " --texels-per-metre ", 0), 0u) << words;

    BakeOptions said{.quality = Quality::draft, .texelsPerMetre = std::stof(words.substr(words.rfind(' '))), .samples = fewest};
    said.threads = 1;
    bakeLevel("content/truth/furnace.glb", folder / "said", said, silent);
    int compared = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "paced")) {
        if (entry.path().filename() == "bake.json") continue; // holds the seconds
        EXPECT_EQ(readFile(entry.path()), readFile(folder / "said" / entry.path().filename())) << entry.path();
        ++compared;
    }
    EXPECT_GE(compared, 3);
    std::filesystem::remove_all(folder);
}

// Where all of it fits, the bake is that of somebody who said no time.
TEST(Pace, changes_no_bit_of_what_fits)
{
    Progress silent(ProgressStyle::none);
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "pace_fits_test";
    std::filesystem::remove_all(folder);
    BakeOptions asked{.quality = Quality::draft};
    bakeLevel("content/truth/furnace.glb", folder / "unpaced", asked, silent);
    asked.timeBudget = 1e6;
    bakeLevel("content/truth/furnace.glb", folder / "paced", asked, silent);
    const auto manifestOf = [&](const char* name) { return nlohmann::json::parse(readText(folder / name / "bake.json")); };
    const nlohmann::json paced = manifestOf("paced"), unpaced = manifestOf("unpaced");
    EXPECT_TRUE(paced["time_budget"]["fits"].get<bool>());
    EXPECT_EQ(paced["time_budget"]["given_up"], "");
    EXPECT_EQ(paced["options"], unpaced["options"]);
    EXPECT_FALSE(unpaced.contains("time_budget"));
    const auto filesOf = [&](const char* name) {
        std::map<std::string, std::vector<std::uint8_t>> files;
        for (const auto& entry : std::filesystem::directory_iterator(folder / name))
            if (entry.path().filename() != "bake.json") files[entry.path().filename()] = readFile(entry.path()); // it holds the seconds
        return files;
    };
    EXPECT_EQ(filesOf("paced"), filesOf("unpaced"));
    EXPECT_GE(filesOf("paced").size(), 3u);
    std::filesystem::remove_all(folder);
}
}
