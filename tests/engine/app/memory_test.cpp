// --max-memory: what does not fit waits on the disk, the result is the same to the bit, and the bound is kept.
#include "baker/memory.hpp"
#include "tests/engine/app/program.hpp"
#include <fstream>
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

namespace
{
// A folder of the test's own.
struct Place {
    std::filesystem::path path;
    explicit Place(const std::string& name) : path(std::filesystem::path(testing::TempDir()) / (name + std::to_string(getpid())))
    {
        std::filesystem::create_directories(path);
    }
    ~Place() { std::filesystem::remove_all(path); }
};
}

// Many texels and few paths.
static int bake(const std::filesystem::path& to, const std::filesystem::path& told, Words more)
{
    Words words = {"bake",      "content/cornell/cornell.glb", "-o", to,           "--only",
                   "lightmaps", "--texels-per-metre",          "64", "--progress", "none"};
    words.insert(words.end(), more.begin(), more.end());
    return wait(startProgram(words, told));
}

static json memoryOf(const std::filesystem::path& baked) { return json::parse(readText(baked / "bake.json"))["memory"]; }

// The least bound, in MiB, that a refusal names.
static std::string leastOf(const std::filesystem::path& told)
{
    const std::string sentence = readText(told), before = "it needs ";
    const std::size_t at = sentence.find(before);
    EXPECT_NE(at, std::string::npos) << sentence;
    return at == std::string::npos ? "" : sentence.substr(at + before.size(), sentence.find('M', at) - at - before.size());
}

// Its light waits on the disk between the rounds, and before the pages are made.
static void expectTheSameWithin(const Words& effort)
{
    const Place place("memory_");
    const std::filesystem::path whole = place.path / "whole.baked", small = place.path / "small.baked", told = place.path / "told";
    const auto with = [&](const std::string& bound) {
        Words words = effort;
        words.insert(words.end(), {"--max-memory", bound});
        return words;
    };
    ASSERT_EQ(bake(whole, told, effort), 0) << readText(told);
    ASSERT_EQ(bake(small, told, with("1M")), 2);
    EXPECT_FALSE(std::filesystem::exists(small));
    EXPECT_FALSE(std::filesystem::exists(place.path / "small.baked.journal")) << "it is refused before the first path";
    const std::string least = leastOf(told);
    ASSERT_EQ(bake(small, told, with(least + "M")), 0) << readText(told);
    EXPECT_FALSE(std::filesystem::exists(place.path / "small.baked.journal"));
    EXPECT_EQ(bakedFiles(small), bakedFiles(whole));

    const json held = memoryOf(whole), streamed = memoryOf(small);
    EXPECT_EQ(held["streamed_bytes"], 0);
    EXPECT_GT(streamed["streamed_bytes"], 4u << 20);
    EXPECT_LE(streamed["peak_bytes"], std::stoull(least) << 20);
    EXPECT_LE(held["peak_bytes"], held["expected_bytes"]);
    EXPECT_LT(streamed["texel_bytes"].get<double>() + 100.0, held["texel_bytes"].get<double>())
        << "sums of a texel are more than 100 bytes";
    EXPECT_GT(streamed["triangle_bytes"], 0.0);

    const std::string more = std::to_string(held["expected_bytes"].get<std::uint64_t>() + (8 << 20));
    Words free = with(more);
    free.push_back("--force");
    ASSERT_EQ(bake(small, told, free), 0);
    EXPECT_EQ(memoryOf(small)["streamed_bytes"], 0) << "what fits is not streamed";
}

TEST(Memory, isBoundedWithTheSameBits) { expectTheSameWithin({"--samples", "2"}); }

// How many cells space takes is known once it is parted: what they need is said before they are lit.
TEST(Memory, holdsProbesOrSaysWhatTheyNeed)
{
    const Place place("probes_");
    const std::filesystem::path baked = place.path / "small.baked", told = place.path / "told";
    const auto bakeWithin = [&](const std::string& bound) {
        return wait(startProgram({"bake", "content/two_rooms/two_rooms_open.glb", "-o", baked, "--only", "probes", "--quality", "draft",
                                  "--probe-spacing", "0.5", "--probe-error", "1", "--light-cache", "off", "--progress", "none",
                                  "--max-memory", bound},
                                 told));
    };
    ASSERT_EQ(bakeWithin("26M"), 2) << readText(told); // the level alone needs 20 to 23
    const std::string sentence = readText(told), before = "cells need ";
    ASSERT_NE(sentence.find(before), std::string::npos) << sentence;
    const std::string least = std::to_string(std::stoull(sentence.substr(sentence.find(before) + before.size())));
    ASSERT_EQ(bakeWithin(least + "M"), 0) << readText(told);
    EXPECT_LE(memoryOf(baked)["peak_bytes"], std::stoull(least) << 20);
}

// The light that they look up, among it; and what each thread holds.
TEST(Memory, holdsProbesAloneWithinWhatIsExpected)
{
    for (const char* threads : {"1", "16"}) {
        const Place place("learned_");
        const std::filesystem::path baked = place.path / "small.baked", told = place.path / "told";
        Words words{
            "bake", "content/cornell/cornell.glb", "-o", baked, "--only", "probes", "--quality", "draft", "--progress", "none", "--threads",
            threads};
        ASSERT_EQ(wait(startProgram(words, told)), 0) << readText(told);
        const json memory = memoryOf(baked);
        const std::uint64_t most = std::uint64_t(memory["expected_bytes"]) + kUneven;
        EXPECT_LE(memory["peak_bytes"], most) << threads;
        EXPECT_EQ(memory["texel_bytes"], 0.0) << "no lightmap is made";
        for (const std::string& word : {std::string("--force"), std::string("--max-memory"), std::to_string((most >> 20) + 1) + "M"})
            words.push_back(word);
        ASSERT_EQ(wait(startProgram(words, told)), 0) << readText(told);
    }
}

TEST(Memory, isBoundedWithTheSameBitsToAStatedError) { expectTheSameWithin({"--target-error", "0.1", "--threads", "3"}); }
}
