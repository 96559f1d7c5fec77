// kill -9 while the program bakes: `--resume` ends with the files of a bake that nobody disturbed.
#include "tests/engine/app/program.hpp"
#include <chrono>
#include <csignal>
#include <thread>

namespace afterglow
{
// The program at work on a small level whose bake takes seconds.
static pid_t start(const std::filesystem::path& place, const Words& more)
{
    Words words = {"bake", "content/cornell/cornell.glb", "-o", place, "--quality", "draft", "--samples", "192"};
    for (const char* word : {"--only", "lightmaps,probes", "--progress", "none"}) words.push_back(word);
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

TEST(Kill, losesNoBitOfABake)
{
    const std::filesystem::path in = std::filesystem::path(testing::TempDir()) / ("kill_" + std::to_string(getpid()));
    const std::filesystem::path whole = in / "whole.baked", killed = in / "killed.baked", journal = in / "killed.baked.journal";
    std::filesystem::create_directories(in);
    ASSERT_EQ(wait(start(whole, {})), 0);
    ASSERT_TRUE(killAfter(start(killed, {}), journal, 200'000)) << "it was too quick to be killed";
    EXPECT_FALSE(std::filesystem::exists(killed));
    ASSERT_TRUE(killAfter(start(killed, {"--resume", "--threads", "1"}), journal, 100'000));
    const std::uintmax_t kept = std::filesystem::file_size(journal);
    ASSERT_EQ(wait(start(killed, {"--seed", "2", "--resume"})), 0) << "another bake starts from the beginning";
    EXPECT_NE(bakedFiles(killed), bakedFiles(whole));
    EXPECT_GT(kept, 300'000u);
    EXPECT_FALSE(std::filesystem::exists(journal));

    std::filesystem::remove_all(killed);
    ASSERT_TRUE(killAfter(start(killed, {}), journal, 300'000));
    ASSERT_TRUE(killAfter(start(killed, {"--resume"}), journal, 100'000));
    ASSERT_EQ(wait(start(killed, {"--resume", "--threads", "3"})), 0);
    EXPECT_EQ(bakedFiles(killed), bakedFiles(whole));
    EXPECT_GE(bakedFiles(whole).size(), 3u);
    EXPECT_FALSE(std::filesystem::exists(journal));
    std::filesystem::remove_all(in);
}
}
