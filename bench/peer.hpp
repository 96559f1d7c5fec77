// Another program, asked for what it measures of itself.
#pragma once
#include <array>
#include <cstdio>
#include <string>

namespace afterglow
{
// What a command of the shell prints; empty where it does not run.
inline std::string outputOf(const std::string& command)
{
    FILE* pipe = popen(command.c_str(), "r");
    std::string said;
    std::array<char, 512> part;
    while (pipe && std::fgets(part.data(), int(part.size()), pipe)) said += part.data();
    if (pipe) pclose(pipe);
    return said;
}
}
