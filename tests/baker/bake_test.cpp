// Whole bakes of small levels: the same bits for any number of threads, nothing left behind when it fails, and light where it must be.
#include "baker/baker.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace afterglow
{
static std::filesystem::path freshFolder(const std::string& name)
{
    std::filesystem::path folder = std::filesystem::temp_directory_path() / ("afterglow_bake_test_" + std::to_string(getpid()) + name);
    std::filesystem::remove_all(folder);
    return folder;
}

static BakeOptions smallBake()
{
    BakeOptions options;
    options.quality = Quality::draft;
    options.texelsPerMetre = 24.0f;
    options.samples = 16;
    options.probeError = 0.0f; // as the spacing says
    options.seed = 7;
    return options;
}

TEST(Bake, isTheSameForOneAndThreeThreads)
{
    Progress silent(ProgressStyle::none);
    std::filesystem::path one = freshFolder("one"), three = freshFolder("three");
    BakeOptions options = smallBake();
    options.threads = 1;
    bakeLevel("content/two_rooms/two_rooms_open.glb", one, options, silent);
    options.threads = 3;
    bakeLevel("content/two_rooms/two_rooms_open.glb", three, options, silent);
    int compared = 0;
    for (const auto& entry : std::filesystem::directory_iterator(one)) {
        if (entry.path().filename() == "bake.json") continue; // holds the seconds
        EXPECT_EQ(readFile(entry.path()), readFile(three / entry.path().filename())) << entry.path();
        compared++;
    }
    EXPECT_GE(compared, 4); // scene, lightmap, its coverage, probes
    std::filesystem::remove_all(one);
    std::filesystem::remove_all(three);
}

TEST(Bake, leavesNothingBehindWhenTheLevelIsMissing)
{
    Progress silent(ProgressStyle::none);
    std::filesystem::path folder = freshFolder("missing");
    EXPECT_THROW(bakeLevel("content/no_such_level.glb", folder, smallBake(), silent), Error);
    EXPECT_FALSE(std::filesystem::exists(folder));
}

// Values whose mean and spread are wanted.
struct Tally {
    double sum = 0.0, squares = 0.0;
    int count = 0;
    void add(float value) { sum += double(value), squares += double(value) * double(value), count++; }
    double mean() const { return sum / count; }
    double deviation() const { return std::sqrt(std::max(squares / count - mean() * mean(), 0.0)); }
};

// A furnace holds the same light everywhere, so its lightmap does too: L = Le / (1 - rho) = 1, irradiance / pi = 1 at every texel.
TEST(Bake, fillsAFurnaceWithItsOneRadiance)
{
    Progress silent(ProgressStyle::none);
    std::filesystem::path folder = freshFolder("furnace");
    BakeOptions options = smallBake();
    options.samples = 256;
    options.texelsPerMetre = 4.0f;
    bakeLevel("content/truth/furnace.glb", folder, options, silent);
    Baked baked = readBaked(folder);
    ASSERT_FALSE(baked.lightmaps.empty());
    Tally texels, probes;
    for (const Lightmap& page : baked.lightmaps)
        for (std::size_t i = 0; i < page.texels.size(); i++)
            if (page.valid[i] == 1) texels.add(page.texels[i].y);
    for (const Probe& probe : baked.probes.probes) probes.add(probeIrradiance(probe, vec3(0, 1, 0)).y);
    ASSERT_GT(texels.count, 100);
    ASSERT_GE(probes.count, 8);
    // Texels of a tile share directions, so 64 of them count as one estimate; half a step of the 9-bit mantissa is stored besides
    EXPECT_NEAR(texels.mean(), 1.0, 4.0 * texels.deviation() / std::sqrt(texels.count / 64.0) + 1.0 / 1024.0);
    EXPECT_NEAR(probes.mean(), 1.0, 4.0 * probes.deviation() / std::sqrt(probes.count));
    std::filesystem::remove_all(folder);
}

static nlohmann::json manifestOf(const std::filesystem::path& folder) { return nlohmann::json::parse(readText(folder / "bake.json")); }

// Free, empty or a bake, with or without a final slash; and a second bake takes the place of the first.
TEST(Bake, goesWhereThereIsRoom)
{
    Progress silent(ProgressStyle::none);
    BakeOptions options = smallBake();
    options.texelsPerMetre = 2.0f;
    std::filesystem::path folder = freshFolder("room");
    std::filesystem::create_directories(folder / "foreign");
    EXPECT_THROW(bakeLevel("content/truth/furnace.glb", folder, options, silent), Error);
    EXPECT_TRUE(std::filesystem::is_empty(folder / "foreign"));
    for (const char* place : {"foreign", "foreign/", "new/folder/"}) {
        bakeLevel("content/truth/furnace.glb", folder / place, options, silent);
        EXPECT_TRUE(isBaked(folder / place)) << place;
    }
    std::filesystem::remove_all(folder);
}

TEST(Bake, neverTakesItsLevelsPlace)
{
    Progress silent(ProgressStyle::none);
    BakeOptions options = smallBake();
    options.lightmaps = options.probes = options.reflections = false;
    std::filesystem::path folder = freshFolder("inside");
    bakeLevel("content/truth/furnace.glb", folder, options, silent);
    EXPECT_THROW(bakeLevel(folder / "scene.glb", folder, options, silent), Error);
    EXPECT_THROW(bakeLevel(folder / "scene.glb", folder / "..", options, silent), Error);
    EXPECT_TRUE(isBaked(folder));
    std::filesystem::remove_all(folder);
}

TEST(Bake, booksWhatItMadeUnderWhatWasAskedFor)
{
    Progress silent(ProgressStyle::none);
    BakeOptions options = smallBake();
    options.lightmaps = options.probes = options.lods = options.voxels = false;
    options.denoiser = Denoiser::none;
    std::filesystem::path folder = freshFolder("only");
    bakeLevel("content/truth/mirror_corridor.glb", folder, options, silent);
    const nlohmann::json manifest = manifestOf(folder);
    EXPECT_EQ(manifest["options"]["only"], nlohmann::json({"reflections"}));
    EXPECT_EQ(manifest["options"]["denoise"], "none");
    EXPECT_EQ(manifest["needs"]["probes"], "off, not in --only");
    EXPECT_GT(manifest["products"]["reflections"]["rays"], 0);
    for (const char* product : {"lightmaps", "probes", "lods"}) EXPECT_FALSE(manifest["products"].contains(product)) << product;
    std::filesystem::remove_all(folder);
}

// The same key, and all files as they were written: bake.json, with its seconds, is the old one.
TEST(Bake, ofAnUnchangedLevelIsNotDoneAgain)
{
    Progress silent(ProgressStyle::none);
    const std::filesystem::path folder = freshFolder("unchanged");
    BakeOptions options = smallBake();
    options.texelsPerMetre = 2.0f;
    options.exr = true;
    std::string last;
    const auto bakesAgain = [&] {
        bakeLevel("content/truth/furnace.glb", folder, options, silent);
        const std::string before = last;
        last = readText(folder / "bake.json");
        return last != before;
    };
    EXPECT_TRUE(bakesAgain());
    EXPECT_FALSE(bakesAgain());
    options.threads = 2;
    EXPECT_FALSE(bakesAgain()) << "the result is the same";
    options.seed = 8;
    EXPECT_TRUE(bakesAgain());
    options.force = true;
    EXPECT_TRUE(bakesAgain());
    options.force = false;
    EXPECT_FALSE(bakesAgain());
    for (const char* name : {"scene.glb", "lightmap_0.ktx2", "lightmap_0.exr"}) {
        std::filesystem::remove(folder / name);
        EXPECT_TRUE(bakesAgain()) << name << " is missing";
        std::filesystem::resize_file(folder / name, std::filesystem::file_size(folder / name) - 1);
        EXPECT_TRUE(bakesAgain()) << name << " is truncated";
    }
    writeText(folder / "bake.json", "{");
    EXPECT_THROW(bakesAgain(), Error) << "it is no bake of ours any more";
    std::filesystem::remove_all(folder);
}
}
