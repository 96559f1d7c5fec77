// The program as a process of its own, for tests of what it leaves behind.
#pragma once
#include "engine/core/file.hpp"
#include <fcntl.h>
#include <gtest/gtest.h>
#include <map>
#include <sys/wait.h>
#include <unistd.h>

namespace afterglow
{
using Words = std::vector<std::string>;

// `told`: the file of what it says on stderr.
inline pid_t startProgram(Words words, const std::filesystem::path& told = "/dev/null")
{
    words.insert(words.begin(), AFTERGLOW_PROGRAM);
    std::vector<char*> list;
    for (std::string& word : words) list.push_back(word.data());
    list.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
        dup2(open(told.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666), STDERR_FILENO);
        execv(AFTERGLOW_PROGRAM, list.data());
        _exit(127);
    }
    return child;
}

// Its exit code; -1: a signal ended it.
inline int wait(pid_t child)
{
    int status = 0;
    EXPECT_EQ(waitpid(child, &status, 0), child);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

// All of a baked folder but bake.json, which holds the seconds.
inline std::map<std::string, std::vector<std::uint8_t>> bakedFiles(const std::filesystem::path& folder)
{
    std::map<std::string, std::vector<std::uint8_t>> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().filename() != "bake.json") files[entry.path().filename()] = readFile(entry.path());
    return files;
}
}
