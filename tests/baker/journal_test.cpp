// What a journal keeps comes back as it was; one that is damaged, foreign or another bake's is never believed.
#include "baker/journal.hpp"
#include "bits.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include <cstring>
#include <fstream>

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

// Of another version it is a journal, whose contents nobody believes: a bake starts from the beginning, and one is not kept from beginning.
TEST(Journal, ofAnotherVersionIsOfAnotherProgram)
{
    const Ground ground("version");
    keepThree(ground);
    Contents other = readFile(ground.file);
    other[std::string_view("afterglow journal ").size()] = '2';
    overwrite(ground.file, other);
    EXPECT_FALSE(Journal(ground.place, kKey, Journal::Start::resume).resumable());
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
    EXPECT_EQ(refused, 8 * 18) << "the words of the magic; its number is that of a program";
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
