// A bake that is stopped anywhere goes on to the same bits; a journal that is damaged, foreign or another bake's is never believed.
#include "baker/journal.hpp"
#include "baker/key.hpp"
#include "bits.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

namespace afterglow
{
static const std::string kKey(64, 'a');

static void keepThree(const Ground& ground)
{
    Journal journal(ground.place, kKey, Journal::Start::afresh);
    journal.keep({Job::lightmaps, 0, 16}, Contents{1, 2, 3}, {10});
    journal.keep({Job::lightmaps, 0, 32}, Contents{}, {20});
    journal.keep({Job::probes, 7}, Contents(1000, 9), {30});
}

// How many of the three are there, all of them as they were kept.
static int whole(const Ground& ground)
{
    Journal journal(ground.place, kKey, Journal::Start::resume);
    const std::pair<Unit, Done> kept[] = {
        {{Job::lightmaps, 0, 16}, {{1, 2, 3}, 10}}, {{Job::lightmaps, 0, 32}, {{}, 20}}, {{Job::probes, 7}, {Contents(1000, 9), 30}}};
    int count = 0;
    bool gone = false;
    for (const auto& [unit, done] : kept) {
        const std::optional<Done> found = journal.recall(unit);
        if (!found) {
            gone = true;
            continue;
        }
        EXPECT_FALSE(gone) << "what follows a damaged record is cut off";
        EXPECT_EQ(found->bytes, done.bytes);
        EXPECT_EQ(found->rays, done.rays);
        count++;
    }
    EXPECT_FALSE(journal.recall({Job::reflections, 0}));
    return count;
}

static void overwrite(const std::filesystem::path& path, const Contents& bytes) { writeFile(path, bytes.data(), bytes.size()); }

TEST(Journal, recallsWhatWasKept)
{
    const Ground ground("recall");
    keepThree(ground);
    EXPECT_EQ(whole(ground), 3);
    Journal(ground.place, kKey, Journal::Start::resume).finish();
    EXPECT_TRUE(ground.isEmpty());
}

TEST(Journal, recallsWhatItKeptItself)
{
    const Ground ground("own");
    Journal journal(ground.place, kKey, Journal::Start::afresh);
    journal.keep({Job::lightmaps, 0, 16}, Contents{1, 2, 3}, {10});
    journal.keep({Job::lightmaps, 0, 32}, Contents{4, 5}, {20});
    EXPECT_EQ(journal.recall({Job::lightmaps, 0, 16})->bytes, (Contents{1, 2, 3}));
    EXPECT_EQ(journal.recall({Job::lightmaps, 0, 32})->bytes, (Contents{4, 5}));
    journal.forget({Job::lightmaps, 0, 16});
    EXPECT_FALSE(journal.recall({Job::lightmaps, 0, 16}));
    EXPECT_TRUE(journal.recall({Job::lightmaps, 0, 32}));
}

TEST(Journal, isNoFileWhenItHoldsNothing)
{
    const Ground ground("nothing");
    {
        const Journal journal(ground.place, kKey, Journal::Start::resume);
        EXPECT_FALSE(journal.resumable());
    }
    EXPECT_TRUE(ground.isEmpty());
}

// As a kill leaves it: any number of bytes of it are there.
TEST(Journal, isCutWhereItIsTorn)
{
    const Ground ground("torn");
    keepThree(ground);
    const Contents all = readFile(ground.file);
    int before = 0;
    for (std::size_t size = 0; size <= all.size(); size++) {
        overwrite(ground.file, {all.begin(), all.begin() + std::ptrdiff_t(size)});
        const int count = whole(ground);
        EXPECT_GE(count, before);
        before = count;
    }
    EXPECT_EQ(before, 3);

    // And goes on from there
    overwrite(ground.file, {all.begin(), all.end() - 1});
    Journal(ground.place, kKey, Journal::Start::resume).keep({Job::probes, 7}, Contents(1000, 9), {30});
    EXPECT_EQ(whole(ground), 3);
}

// No bit of it can change unseen: what it is in is not recalled, or the file is not taken for a journal at all.
TEST(Journal, refusesEveryFlippedBit)
{
    const Ground ground("flipped");
    keepThree(ground);
    const Contents all = readFile(ground.file);
    int refused = 0;
    for (std::size_t bit = 0; bit < 8 * all.size(); bit += bit < 8 * 250 ? 1 : 61) {
        Contents flipped = all;
        flipped[bit / 8] ^= std::uint8_t(1 << bit % 8);
        overwrite(ground.file, flipped);
        try {
            EXPECT_LT(whole(ground), 3) << "bit " << bit;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find("is not the journal of a bake"), std::string::npos);
            EXPECT_EQ(readFile(ground.file), flipped) << "a stranger's file is left alone";
            refused++;
        }
    }
    EXPECT_EQ(refused, 8 * 20) << "the magic";
}

// A size that is not there allocates nothing.
TEST(Journal, followsNoHugeSize)
{
    const Ground ground("huge");
    keepThree(ground);
    Contents all = readFile(ground.file);
    for (const std::uint32_t size : {0xffffffffu, 0x7fffffffu, 0x3fffffffu, 1u << 20}) {
        std::memcpy(&all[84 + 28], &size, sizeof size); // after magic and key, checksum and unit
        overwrite(ground.file, all);
        EXPECT_EQ(whole(ground), 0);
    }
}

TEST(Journal, isOfOneKeyOnly)
{
    const Ground ground("key");
    keepThree(ground);
    const std::string other(64, 'b');
    {
        testing::internal::CaptureStderr();
        Journal journal(ground.place, other, Journal::Start::resume);
        EXPECT_NE(testing::internal::GetCapturedStderr().find("it starts from the beginning"), std::string::npos);
        EXPECT_FALSE(journal.recall({Job::probes, 7}));
        journal.keep({Job::probes, 8}, Contents{1}, {1});
    }
    EXPECT_EQ(whole(ground), 0);
    EXPECT_TRUE(Journal(ground.place, other, Journal::Start::resume).recall({Job::probes, 8}));
}

// Nobody is robbed by a command that says nothing of resuming: it says so, and the old one stands until there is something new to keep.
TEST(Journal, startsAfreshUnlessAsked)
{
    const Ground ground("afresh");
    keepThree(ground);
    {
        testing::internal::CaptureStderr();
        const Journal journal(ground.place, kKey, Journal::Start::afresh);
        EXPECT_NE(testing::internal::GetCapturedStderr().find("--resume goes on with it"), std::string::npos);
        EXPECT_FALSE(journal.recall({Job::probes, 7}));
        EXPECT_EQ(journal.before().seconds, 0.0);
    }
    EXPECT_EQ(whole(ground), 3);
    Journal(ground.place, kKey, Journal::Start::afresh).keep({Job::probes, 8}, Contents{1}, {1});
    EXPECT_EQ(whole(ground), 0);
}

TEST(Journal, isHeldByOneBakeAtATime)
{
    const Ground ground("held");
    const Journal first(ground.place, kKey, Journal::Start::afresh);
    try {
        const Journal second(ground.place, kKey, Journal::Start::resume);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).rfind("another bake is writing", 0), 0u) << error.what();
    }
}

TEST(Journal, countsTheTimeOfAllWhoWorked)
{
    const Ground ground("time");
    Spent first;
    {
        Journal journal(ground.place, kKey, Journal::Start::afresh);
        journal.keep({Job::lightmaps, 0}, Contents{}, {0});
        journal.keep({Job::probes, 0}, Contents{}, {0});
        first = journal.spent();
    }
    const Journal journal(ground.place, kKey, Journal::Start::resume);
    EXPECT_GT(journal.before().seconds, 0.0);
    EXPECT_LE(journal.before().seconds, first.seconds);
    EXPECT_NEAR(journal.before().seconds, journal.before(Job::lightmaps).seconds + journal.before(Job::probes).seconds, 1e-9);
    EXPECT_GE(journal.spent().seconds, journal.before().seconds);
}

// All that makes another result makes another key, and nothing else does.
TEST(BakeKey, isOfTheResult)
{
    const std::filesystem::path level = "content/truth/furnace.glb";
    const std::string key = bakeKey(level, {});
    EXPECT_EQ(key.size(), 64u);
    const auto keyOf = [&](auto change) {
        BakeOptions options;
        change(options);
        return bakeKey(level, options);
    };
    EXPECT_EQ(keyOf([](BakeOptions& o) { o.threads = 3; }), key);
    EXPECT_EQ(keyOf([](BakeOptions& o) { o.resume = true; }), key);
    EXPECT_NE(keyOf([](BakeOptions& o) { o.seed = 2; }), key);
    EXPECT_NE(keyOf([](BakeOptions& o) { o.samples = 8; }), key);
    EXPECT_NE(keyOf([](BakeOptions& o) { o.targetError = 0.1f; }), key);
    EXPECT_NE(keyOf([](BakeOptions& o) { o.lods = false; }), key);
    EXPECT_NE(keyOf([](BakeOptions& o) { o.exr = true; }), key);
    EXPECT_NE(keyOf([](BakeOptions& o) { o.lightLayers = true; }), key);
    EXPECT_NE(keyOf([](BakeOptions& o) { o.incremental = true; }), key);

    // A file beside the level, there or not, and its bytes
    const Ground ground("beside");
    const std::filesystem::path named = ground.folder / "level.gltf";
    writeText(named, R"({"asset":{"version":"2.0"},"images":[{"uri":"a%20b.png"}],"scenes":[{"extras":{"ag_sky_image":"sky.hdr"}}]})");
    std::vector<std::string> keys = {bakeKey(named, {})};
    for (const auto& [name, text] : {std::pair("a b.png", "1"), {"a b.png", "2"}, {"sky.hdr", "1"}}) {
        writeText(ground.folder / name, text);
        keys.push_back(bakeKey(named, {}));
        EXPECT_NE(keys.back(), keys[keys.size() - 2]) << name;
    }
}

// Bits of everything that a bake makes, and what it says of it but times.
static std::pair<Contents, std::string> bitsOf(const Baked& baked, nlohmann::json told)
{
    told.erase("threads"), told.erase("memory");
    for (nlohmann::json& product : told["products"]) product.erase("seconds"), product.erase("cpu_seconds");
    return {bitsOf(baked), told.dump()};
}

// Stopped after so many bytes of its journal, and gone on with on so many threads.
static void expectTheSame(const std::string& level, const BakeOptions& asked, const std::string& name)
{
    const Ground ground(name);
    Progress silent(ProgressStyle::none);
    const auto bake = [&](int threads, Journal* journal) {
        BakeOptions options = asked;
        options.threads = threads;
        nlohmann::json told;
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
}

static BakeOptions quick()
{
    BakeOptions options;
    options.quality = Quality::draft;
    options.texelsPerMetre = 8.0f;
    options.samples = 4, options.probeSamples = 8, options.reflectionSize = 8, options.reflectionSamples = 2;
    return options;
}

TEST(Resume, endsAsAnUndisturbedBake) { expectTheSame("content/truth/mirror_corridor.glb", quick(), "resume"); }

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

// A complete bake leaves it to the next one, which only reads it; what is not a journal is nobody's to replace.
TEST(Journal, isKeptUnderAnotherName)
{
    const Ground ground("kept");
    const std::filesystem::path kept = ground.folder / "kept";
    keepThree(ground);
    Journal(ground.place, kKey, Journal::Start::resume).finish(kept);
    EXPECT_FALSE(std::filesystem::exists(ground.file));
    EXPECT_EQ(Journal(kept).recall({Job::probes, 7})->bytes, Contents(1000, 9));
    Contents all = readFile(kept);
    for (const std::size_t size : {std::size_t(0), std::size_t(10), std::size_t(84), std::size_t(90), all.size() - 1}) {
        overwrite(kept, {all.begin(), all.begin() + std::ptrdiff_t(size)});
        EXPECT_FALSE(Journal(kept).recall({Job::probes, 7})) << size;
    }
    all[0] ^= 1;
    overwrite(kept, all);
    EXPECT_THROW(Journal{kept}, Error);
}
}
