#include "engine/core/jobs.hpp"
#include "engine/core/progress.hpp"
#include <gtest/gtest.h>

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
    EXPECT_EQ(text.find(R"({"stage":"lightmaps","done":8,"total":8,"rate":)"), 0u) << text;
    EXPECT_NE(text.find(R"("eta_s":)"), std::string::npos) << text;
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
}
