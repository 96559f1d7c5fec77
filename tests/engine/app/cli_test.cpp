// The words of the command line: what is said, and the exit code.
#include "engine/app/cli.hpp"
#include "engine/app/runtime_verbs.hpp"
#include "engine/app/verbs.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
struct Answer {
    int code;
    std::string out, err;
};
static Answer ask(std::vector<const char*> words)
{
    words.insert(words.begin(), "afterglow");
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code = runCommandLine(int(words.size()), words.data());
    return {code, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
}

TEST(CommandLine, says_its_version)
{
    const Answer answer = ask({"--version"});
    EXPECT_EQ(answer.code, 0);
    EXPECT_EQ(answer.out, "afterglow " AFTERGLOW_VERSION "\n");
}

TEST(CommandLine, names_what_it_does_not_know_in_its_order)
{
    const Answer answer = ask({"render", "level", "-o", "a.png", "--mode", "truth"});
    EXPECT_EQ(answer.code, 2);
    EXPECT_EQ(answer.err, "afterglow: render: not expected: --mode truth; see `afterglow --help`\n");
}

TEST(CommandLine, says_which_occlusion_there_is)
{
    for (const char* method : {"ray", "nothing"}) {
        const Answer answer = ask({"render", "level.glb", "-o", "a.png", "--ao", method});
        EXPECT_EQ(answer.code, 2) << method;
        EXPECT_NE(answer.err.find("--ao"), std::string::npos) << answer.err;
    }
    EXPECT_EQ(ask({"plan", "no.glb", "--ao", "hbao", "--ao-range", "0"}).code, 2);
}

// So that what both draw can be compared without a word about sizes.
TEST(CommandLine, draws_and_traces_pictures_of_one_size)
{
    EXPECT_EQ(uvec2(TruthCommand{}.options.size), RenderCommand{}.settings.size);
    EXPECT_EQ(ViewCommand{}.settings.size, RenderCommand{}.settings.size);
}

// Before the level is so much as opened.
TEST(CommandLine, asks_for_the_output_first)
{
    for (const std::vector<const char*>& words : {std::vector{"render", "no.glb", "-o", "/proc/nowhere/a.png"},
                                                  {"render", "no.glb", "-o", "a.png", "--stats", "/proc/nowhere/s.json"},
                                                  {"truth", "no.glb", "-o", "/proc/nowhere/a.exr"},
                                                  {"bake", "no.glb", "-o", "/proc/nowhere/baked"}}) {
        const Answer answer = ask(words);
        EXPECT_EQ(answer.code, 3);
        EXPECT_EQ(answer.err.rfind("afterglow: cannot write /proc/nowhere", 0), 0u) << answer.err;
    }
}
}
