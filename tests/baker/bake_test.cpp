// Whole bakes of small levels: the same bits for any number of threads, nothing left behind when it fails, and light where it must be.
#include "baker/baker.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include <cmath>
#include <gtest/gtest.h>
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
    for (const ProbeVolume& volume : baked.probes)
        for (std::size_t i = 0; i < volume.validity.size(); i++)
            if (volume.validity[i] > 0.0f) probes.add(shIrradiance(volume.irradiance[i], vec3(0, 1, 0)).y);
    ASSERT_GT(texels.count, 100);
    ASSERT_GE(probes.count, 8);
    // Texels of a tile share directions, so 64 of them count as one estimate; half a step of the 9-bit mantissa is stored besides
    EXPECT_NEAR(texels.mean(), 1.0, 4.0 * texels.deviation() / std::sqrt(texels.count / 64.0) + 1.0 / 1024.0);
    EXPECT_NEAR(probes.mean(), 1.0, 4.0 * probes.deviation() / std::sqrt(probes.count));
    std::filesystem::remove_all(folder);
}
}
