#include "engine/core/jobs.hpp"
#include <atomic>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace afterglow
{
TEST(Jobs, visit_every_index_once_on_any_number_of_threads)
{
    for (int threads : {1, 2, 7, 0}) {
        std::vector<std::atomic<int>> visits(1000);
        parallelFor(visits.size(), threads, [&](std::size_t i) { ++visits[i]; });
        for (const auto& count : visits) EXPECT_EQ(count, 1);
    }
    parallelFor(0, 4, [](std::size_t) { FAIL(); });
}

TEST(Jobs, pass_on_what_was_thrown_and_stop)
{
    for (int threads : {1, 3}) {
        std::atomic<int> done{0};
        const auto work = [&](std::size_t i) {
            if (i == 10) throw std::runtime_error("ten");
            ++done;
        };
        EXPECT_THROW(parallelFor(1u << 20, threads, work), std::runtime_error);
        EXPECT_LT(done, 1 << 20);
    }
}

#if defined(__SSE2__)
TEST(Jobs, flush_denormals_in_every_thread_and_leave_the_caller_as_it_was)
{
    volatile float smallest = std::numeric_limits<float>::min(), half = 0.5f;
    for (int threads : {1, 4}) {
        std::atomic<int> alive{0};
        parallelFor(100, threads, [&](std::size_t) {
            if (smallest * half != 0.0f) ++alive;
        });
        EXPECT_EQ(alive, 0);
        EXPECT_NE(smallest * half, 0.0f);
    }
}
#endif
}
