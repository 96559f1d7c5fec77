// kill -9 while the program bakes: `--resume` ends with the files of a bake that nobody disturbed.
#include "tests/engine/app/program.hpp"
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

namespace afterglow
{
// The program at work on a small level whose bake takes seconds.
static pid_t start(const std::filesystem::path& place, const Words& more)
{
    Words words = {"bake", "content/cornell/cornell.glb", "-o", place, "--quality", "draft", "--progress", "none"};
    words.insert(words.end(), more.begin(), more.end());
    return startProgram(words);
}

// Kills it as soon as it has kept so many bytes more. False: it ended before.
static bool killAfter(pid_t child, const std::filesystem::path& journal, std::uintmax_t bytes)
{
    const auto size = [&] {
        std::error_code none;
        const std::uintmax_t found = std::filesystem::file_size(journal, none);
        return none ? 0 : found;
    };
    const std::uintmax_t before = size();
    while (size() < before + bytes) {
        if (waitpid(child, nullptr, WNOHANG) != 0) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    kill(child, SIGKILL);
    return wait(child) == -1;
}

static const Words kSmall = {"--samples", "192", "--only", "lightmaps,probes"};

static Words with(Words words, const Words& more)
{
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

TEST(Kill, losesNoBitOfABake)
{
    const std::filesystem::path in = std::filesystem::path(testing::TempDir()) / ("kill_" + std::to_string(getpid()));
    const std::filesystem::path whole = in / "whole.baked", killed = in / "killed.baked", journal = in / "killed.baked.journal";
    std::filesystem::create_directories(in);
    ASSERT_EQ(wait(start(whole, kSmall)), 0);
    ASSERT_TRUE(killAfter(start(killed, kSmall), journal, 200'000)) << "it was too quick to be killed";
    EXPECT_FALSE(std::filesystem::exists(killed));
    ASSERT_TRUE(killAfter(start(killed, with(kSmall, {"--resume", "--threads", "1"})), journal, 100'000));
    const std::uintmax_t kept = std::filesystem::file_size(journal);
    ASSERT_EQ(wait(start(killed, with(kSmall, {"--seed", "2", "--resume"}))), 0) << "another bake starts from the beginning";
    EXPECT_NE(bakedFiles(killed), bakedFiles(whole));
    EXPECT_GT(kept, 300'000u);
    EXPECT_FALSE(std::filesystem::exists(journal));

    std::filesystem::remove_all(killed);
    ASSERT_TRUE(killAfter(start(killed, kSmall), journal, 300'000));
    ASSERT_TRUE(killAfter(start(killed, with(kSmall, {"--resume"})), journal, 100'000));
    ASSERT_EQ(wait(start(killed, with(kSmall, {"--resume", "--threads", "3"}))), 0);
    EXPECT_EQ(bakedFiles(killed), bakedFiles(whole));
    EXPECT_GE(bakedFiles(whole).size(), 3u);
    EXPECT_FALSE(std::filesystem::exists(journal));
    std::filesystem::remove_all(in);
}

// Its light waits in the journal, of which the bake has no other copy; and what is left for the next bake is as whole.
TEST(Kill, slowLosesNoBitOfLightThatWaitsOnTheDisk)
{
    const std::filesystem::path in = std::filesystem::path(testing::TempDir()) / ("kill_disk_" + std::to_string(getpid()));
    const std::filesystem::path whole = in / "whole.baked", killed = in / "killed.baked", journal = in / "killed.baked.journal";
    std::filesystem::create_directories(in);
    Words words = {"--texels-per-metre", "64", "--target-error", "0.1", "--only", "lightmaps", "--light-layers", "--incremental"};
    ASSERT_EQ(wait(start(whole, words)), 0);
    const nlohmann::json told = nlohmann::json::parse(readText(whole / "bake.json"));
    const auto texels = told["products"]["lightmaps"]["texels"].get<std::uint64_t>();
    const std::uint64_t bound = told["memory"]["expected_bytes"].get<std::uint64_t>() - 64 * texels; // of 128 that wait
    words = with(words, {"--max-memory", std::to_string(bound)});
    ASSERT_TRUE(killAfter(start(killed, words), journal, 1'000'000)) << "it was too quick to be killed";
    ASSERT_TRUE(killAfter(start(killed, with(words, {"--resume", "--threads", "1"})), journal, 2'000'000));
    ASSERT_EQ(wait(start(killed, with(words, {"--resume", "--threads", "3"}))), 0);
    EXPECT_EQ(bakedFiles(killed), bakedFiles(whole));
    EXPECT_GT(nlohmann::json::parse(readText(killed / "bake.json"))["memory"]["streamed_bytes"], 0);
    EXPECT_FALSE(std::filesystem::exists(journal));
    ASSERT_EQ(wait(start(killed, with(words, {"--force"}))), 0);
    EXPECT_EQ(bakedFiles(killed), bakedFiles(whole));
    EXPECT_EQ(nlohmann::json::parse(readText(killed / "bake.json"))["rays"], 0);
    std::filesystem::remove_all(in);
}
}
