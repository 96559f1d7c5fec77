#include "engine/core/forecast.hpp"
#include "engine/core/jobs.hpp"
#include "engine/core/progress.hpp"
#include <gtest/gtest.h>
#include <thread>

namespace afterglow
{
static std::string told(ProgressStyle style)
{
    testing::internal::CaptureStderr();
    Progress progress(style);
    progress.begin("lightmaps", 8, "tiles");
    parallelFor(8, 2, [&](std::size_t) { progress.advance(1); });
    progress.end();
    return testing::internal::GetCapturedStderr();
}

TEST(Progress, is_one_json_object_a_line_for_machines)
{
    const std::string text = told(ProgressStyle::json);
    EXPECT_EQ(text.find(R"({"stage":"lightmaps","done":8,"total":8,"unit":"tiles","rate":)"), 0u) << text;
    for (const char* key : {"seconds", "eta_s", "all_seconds", "all_eta_s"})
        EXPECT_NE(text.find('"' + std::string(key) + "\":"), std::string::npos) << text;
    EXPECT_EQ(text.back(), '\n');
}

TEST(Progress, is_plain_lines_where_there_is_no_terminal)
{
    for (ProgressStyle style : {ProgressStyle::plain, ProgressStyle::automatic}) {
        const std::string text = told(style);
        EXPECT_EQ(text.find("lightmaps: 100 % (8 of 8 tiles"), 0u) << text;
        EXPECT_EQ(text.find('\r'), std::string::npos);
    }
    EXPECT_EQ(told(ProgressStyle::none), "");
}

// Of a plan, the stages to come are in the time of all, by what the one at hand has shown; what was found done has not.
TEST(Progress, knows_how_long_all_stages_take)
{
    testing::internal::CaptureStderr();
    Progress progress(ProgressStyle::json);
    progress.plan({{"lightmaps", 100, 1.0}, {"probes", 300, 1.0}});
    progress.begin("lightmaps", 8, "tiles");
    std::this_thread::sleep_for(std::chrono::milliseconds(20)); // some time: how much, the line says
    progress.find(4);
    progress.advance(4);
    progress.end();
    const std::string text = testing::internal::GetCapturedStderr();
    const auto number = [&](const std::string& key) { return std::stod(text.substr(text.find('"' + key + "\":") + key.size() + 3)); };
    EXPECT_EQ(number("eta_s"), 0.0);
    EXPECT_NEAR(number("rate"), 4.0 / number("seconds"), 1e-3 * number("rate"));
    EXPECT_GT(number("all_eta_s"), 0.0);
    EXPECT_LT(number("all_eta_s"), 100.0); // of 300 that were reckoned: the first stage was done in far less than its 4
}
// Ten units that take three times as long are worth thirty of the ninety to come.
TEST(Progress, knows_that_the_first_units_cost_more)
{
    testing::internal::CaptureStderr();
    Progress progress(ProgressStyle::json);
    progress.begin("lightmaps", 100, "paths");
    progress.costlyFirst(10, 3.0);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    progress.advance(10);
    progress.end();
    const std::string text = testing::internal::GetCapturedStderr(), last = text.substr(text.rfind("{\"stage"));
    const auto number = [&](const std::string& key) { return std::stod(last.substr(last.find('"' + key + "\":") + key.size() + 3)); };
    EXPECT_NEAR(number("eta_s"), 3.0 * number("seconds"), 3e-3); // both in whole milliseconds
}
}
