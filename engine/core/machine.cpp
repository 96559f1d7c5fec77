#include "engine/core/machine.hpp"
#include <fstream>

namespace afterglow
{
std::string processorName()
{
    std::ifstream told("/proc/cpuinfo");
    for (std::string line; std::getline(told, line);)
        if (const std::size_t at = line.find(": "); line.starts_with("model name") && at != std::string::npos) return line.substr(at + 2);
    return "CPU";
}

double machineLoad()
{
    double load = 0.0;
    std::ifstream("/proc/loadavg") >> load;
    return load;
}
}
