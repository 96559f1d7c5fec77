// What is streamed, what fits, what is refused; that a bake keeps to it, tests/engine/app/memory_test.cpp asks the program.
#include "baker/memory.hpp"
#include "baker/seams.hpp"
#include "baker/tile_light.hpp"
#include "engine/core/error.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
constexpr std::uint64_t kMebibyte = 1 << 20;

TEST(MemoryPlan, streamsOnlyWhatDoesNotFit)
{
    const BakeMemory lightmaps = memoryOf({.pages = {ivec2(1024), ivec2(1024)}});
    EXPECT_EQ(lightmaps.light, 2 * kMebibyte * sizeof(TexelLight));
    const ProcessMemory held{100 * kMebibyte, 120 * kMebibyte};
    const MemoryPlan free = planMemory(lightmaps, held, std::nullopt, true);
    EXPECT_FALSE(free.streamed);
    EXPECT_FALSE(planMemory(lightmaps, held, free.expected, true).streamed);
    const MemoryPlan small = planMemory(lightmaps, held, free.expected - 1, true);
    EXPECT_TRUE(small.streamed);
    EXPECT_GE(free.expected, small.expected + lightmaps.light);
    EXPECT_TRUE(planMemory(lightmaps, held, small.expected, true).streamed);
}

TEST(MemoryPlan, refusesInOneSentenceThatNamesTheLeast)
{
    const BakeMemory lightmaps = memoryOf({.pages = {ivec2(512)}, .directional = true});
    const ProcessMemory held{100 * kMebibyte, 100 * kMebibyte};
    const std::uint64_t least = planMemory(lightmaps, held, 1000 * kMebibyte, true).expected - lightmaps.light;
    const auto sentenceOf = [&](std::uint64_t bound, bool hasDisk) {
        try {
            planMemory(lightmaps, held, bound, hasDisk);
        } catch (const Error& error) {
            EXPECT_EQ(error.exit, Exit::usage);
            return std::string(error.what());
        }
        return std::string();
    };
    const std::string sentence = sentenceOf(60 * kMebibyte, true);
    EXPECT_NE(sentence.find("--max-memory 60M does not hold this bake"), std::string::npos) << sentence;
    const std::uint64_t named = std::stoull(sentence.substr(sentence.find("needs ") + 6)) * kMebibyte;
    EXPECT_LE(named, least + 3 * kMebibyte);
    EXPECT_EQ(sentenceOf(named, true), "");
    EXPECT_NE(sentenceOf(named - 4 * kMebibyte, true), "");
    EXPECT_NE(sentenceOf(named, false), "") << "there is no disk to stream to";
}

// What was held once, an atlas on its way, cannot be taken back.
TEST(MemoryPlan, countsThePeakThatWas)
{
    const ProcessMemory held{10 * kMebibyte, 500 * kMebibyte};
    EXPECT_EQ(planMemory({}, held, std::nullopt, true).expected, held.peak);
    EXPECT_THROW(planMemory({}, held, 400 * kMebibyte, true), Error);
    EXPECT_FALSE(planMemory({}, held, 500 * kMebibyte, true).streamed);
}

// Stages follow one another: the greater counts.
TEST(MemoryPlan, countsWhatComesAfterTheLightmaps)
{
    const BakeMemory lods = memoryOf({.triangles = 1'000'000}), both = memoryOf({.pages = {ivec2(64)}, .triangles = 1'000'000});
    const ProcessMemory held{10 * kMebibyte, 10 * kMebibyte};
    EXPECT_GT(planMemory(lods, held, std::nullopt, true).expected, 600'000'000u);
    EXPECT_LT(planMemory(both, held, std::nullopt, true).expected - planMemory(lods, held, std::nullopt, true).expected, kMebibyte);
}

TEST(MemoryPlan, countsEachThread)
{
    const ProcessMemory held{10 * kMebibyte, 10 * kMebibyte};
    const auto by = [&](int threads) { return planMemory(memoryOf({.threads = threads}), held, std::nullopt, true).expected; };
    EXPECT_GE(by(16) - by(1), 15u * 220'000u) << "what was measured of each";
    EXPECT_LT(by(16) - by(1), 15u * 300'000u);
}

// The equations of a level with more seams than its pages have texels.
TEST(MemoryPlan, knowsOfSeams)
{
    const BakeMemory plain = memoryOf({.pages = {ivec2(64)}}), cut = memoryOf({.pages = {ivec2(64)}, .seamPoints = 100'000});
    EXPECT_GT(cut.work, plain.work + 100'000 * sizeof(SeamPoint));
    EXPECT_EQ(cut.pages, plain.pages);
}

// A texel's own.
TEST(MemoryPlan, knowsOfDirections)
{
    const std::vector<ivec2> pages(8, ivec2(256));
    const BakeMemory flat = memoryOf({.pages = pages}), bent = memoryOf({.pages = pages, .directional = true});
    EXPECT_EQ(bent.pages - flat.pages, 8 * 256 * 256 * sizeof(vec4));
    EXPECT_EQ(bent.light, flat.light);
}
}
