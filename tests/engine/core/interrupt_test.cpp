#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include "engine/core/interrupt.hpp"
#include "engine/core/jobs.hpp"
#include "engine/core/progress.hpp"
#include "engine/core/scaffold.hpp"
#include <atomic>
#include <csignal>
#include <gtest/gtest.h>

namespace afterglow
{
static Exit exitOf(const std::function<void()>& stage)
{
    try {
        stage();
    } catch (const Error& error) {
        return error.exit;
    }
    return Exit::done;
}

TEST(Interrupt, stops_the_jobs_of_a_stage_at_the_next_index)
{
    for (int threads : {1, 3}) {
        Progress progress(ProgressStyle::none);
        progress.begin("tiles", 1u << 20, "tiles");
        std::atomic<int> done{0};
        EXPECT_EQ(exitOf([&] {
                      parallelFor(1u << 20, threads, [&](std::size_t) {
                          if (++done == 100) std::raise(SIGINT);
                      });
                  }),
                  Exit::interrupted);
        EXPECT_LT(done, 1 << 20);
    }
}

TEST(Interrupt, of_the_last_step_ends_the_stage_too)
{
    Progress progress(ProgressStyle::none);
    progress.begin("tiles", 1, "tiles");
    std::raise(SIGTERM);
    EXPECT_EQ(exitOf([&] { progress.end(); }), Exit::interrupted);
}

TEST(Interrupt, is_forgotten_by_the_next_command)
{
    {
        Progress progress(ProgressStyle::none);
        progress.begin("tiles", 1, "tiles");
        std::raise(SIGINT);
    }
    Progress progress(ProgressStyle::none);
    EXPECT_EQ(exitOf(stopIfInterrupted), Exit::done);
}

// What stands half-written is removed first, in a stage or out of it, and however often the keys were pressed.
TEST(Interrupt, while_writing_leaves_nothing)
{
    const std::filesystem::path in = std::filesystem::path(testing::TempDir()) / "interrupt_writing";
    std::filesystem::remove_all(in);
    for (Scaffold::Kind kind : {Scaffold::Kind::file, Scaffold::Kind::folder}) {
        hearInterrupts();
        EXPECT_EQ(exitOf([&] {
                      Scaffold built(in / "a", kind);
                      for (int i = 0; i < 3; ++i) std::raise(SIGINT);
                      built.takePlace();
                  }),
                  Exit::interrupted);
        EXPECT_TRUE(std::filesystem::is_empty(in));
    }
    hearInterrupts();
}

TEST(InterruptDeathTest, after_a_file_took_its_place_does_not_deny_it)
{
    const auto leave = [] {
        hearInterrupts();
        writeText(std::filesystem::path(testing::TempDir()) / "interrupt_written", "text");
        std::raise(SIGINT);
    };
    EXPECT_EXIT(leave(), testing::ExitedWithCode(130), "interrupted: what was written before is whole");
}

// Between stages nothing is half-written, and nobody would hear.
TEST(InterruptDeathTest, outside_a_stage_ends_the_program)
{
    const auto leave = [] {
        Progress progress(ProgressStyle::none);
        progress.begin("tiles", 0, "tiles");
        progress.end();
        std::raise(SIGINT);
    };
    EXPECT_EXIT(leave(), testing::ExitedWithCode(130), "afterglow: interrupted: nothing was written");
}

TEST(InterruptDeathTest, of_a_viewer_speaks_of_no_files)
{
    const auto leave = [] {
        hearInterrupts();
        tellWatching();
        std::raise(SIGINT);
    };
    EXPECT_EXIT(leave(), testing::ExitedWithCode(130), "^afterglow: interrupted\n$");
}

TEST(InterruptDeathTest, twice_does_not_wait_for_the_stage)
{
    const auto leave = [] {
        Progress progress(ProgressStyle::none);
        progress.begin("tiles", 1, "tiles");
        std::raise(SIGINT);
        std::raise(SIGINT);
    };
    EXPECT_EXIT(leave(), testing::ExitedWithCode(130), "interrupted");
}
}
