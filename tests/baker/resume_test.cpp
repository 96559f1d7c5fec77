// A bake that is stopped anywhere goes on to the same bits.
#include "baker/journal.hpp"
#include "bits.hpp"
#include "engine/core/file.hpp"
#include <nlohmann/json.hpp>

namespace afterglow
{
static const std::string kKey(64, 'a');

// Bits of everything that a bake makes, and what it says of it but times.
static std::pair<Contents, std::string> bitsOf(const Baked& baked, nlohmann::json told)
{
    told.erase("threads"), told.erase("memory");
    for (nlohmann::json& product : told["products"]) product.erase("seconds"), product.erase("cpu_seconds"), product.erase("place_seconds");
    return {bitsOf(baked), told.dump()};
}

// Stopped after so many bytes of its journal, and gone on with on so many threads.
// Returns what the bake tells.
static nlohmann::json expectTheSame(const std::string& level, const BakeOptions& asked, const std::string& name)
{
    const Ground ground(name);
    Progress silent(ProgressStyle::none);
    nlohmann::json told;
    const auto bake = [&](int threads, Journal* journal) {
        BakeOptions options = asked;
        options.threads = threads;
        told = {};
        const Baked baked = bakeScene(loadLevel(level), options, silent, told, journal);
        return bitsOf(baked, told);
    };
    const auto undisturbed = bake(1, nullptr);
    const auto resumed = [&](int threads) {
        Journal journal(ground.place, kKey, Journal::Start::resume);
        return bake(threads, &journal);
    };
    EXPECT_EQ(resumed(2), undisturbed) << "with a journal";
    Contents all = readFile(ground.file);
    const auto size = double(all.size());
    EXPECT_EQ(resumed(3), undisturbed) << "with all of it recalled";
    EXPECT_EQ(readFile(ground.file), all) << "and nothing done";
    for (const double share : {0.0001, 0.1, 0.37, 0.62, 0.85, 0.98}) {
        overwrite(ground.file, {all.begin(), all.begin() + std::ptrdiff_t(share * size)});
        EXPECT_EQ(resumed(share < 0.5 ? 1 : 3), undisturbed) << share << " of it recalled";
    }
    // Killed again and again: a third of what was left is gone each time
    overwrite(ground.file, Contents(all.begin(), all.begin() + std::ptrdiff_t(0.2 * size)));
    for (int kill = 0; kill < 3; kill++) {
        EXPECT_EQ(resumed(2), undisturbed) << "killed " << kill;
        all = readFile(ground.file);
        all.resize(all.size() / 3 * 2);
        overwrite(ground.file, all);
    }
    return told;
}

static BakeOptions quick()
{
    BakeOptions options;
    options.quality = Quality::draft;
    options.texelsPerMetre = 8.0f;
    options.samples = 4, options.probeSamples = 8, options.reflectionSize = 8, options.reflectionSamples = 2;
    return options;
}

TEST(Resume, endsAsAnUndisturbedBake)
{
    BakeOptions options = quick();
    options.probeNoise = 1e9f; // as many paths as are said: minutes, under the sanitizers
    expectTheSame("content/truth/mirror_corridor.glb", options, "resume");
}

TEST(Resume, endsWithTheSameProbesThatFillALightCache)
{
    BakeOptions options = quick();
    options.lightmaps = options.reflections = options.lods = options.voxels = false;
    const nlohmann::json told = expectTheSame("content/cornell/cornell.glb", options, "learned");
    EXPECT_TRUE(told["products"]["probes"].contains("learned"));
}

TEST(Resume, endsWithTheSameLevelsOfDetail)
{
    BakeOptions options = quick();
    options.lightmaps = options.probes = options.reflections = options.voxels = false;
    expectTheSame("content/two_rooms/two_rooms_open.glb", options, "lods");
}

TEST(Resume, endsAsAnUndisturbedBakeToAStatedError)
{
    BakeOptions options = quick();
    options.texelsPerMetre = 4.0f;
    options.samples.reset();
    options.targetError = 0.2f;
    expectTheSame("content/cornell/cornell.glb", options, "target");
}

TEST(Resume, endsAsAnUndisturbedBakeOfLightLayers)
{
    BakeOptions options = quick();
    options.lightLayers = options.incremental = true;
    options.samples = 20; // a few, then the others
    options.probes = options.reflections = options.lods = options.voxels = false;
    expectTheSame("content/truth/lamps.glb", options, "layers");
}
}
