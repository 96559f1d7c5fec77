// Runs the program as a shell would.
#pragma once
#include "engine/app/cli.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
// What it said, and its exit code.
struct Answer {
    int code;
    std::string out, err;
};
inline Answer ask(std::vector<const char*> words)
{
    words.insert(words.begin(), "afterglow");
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code = runCommandLine(int(words.size()), words.data());
    return {code, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
}
}
