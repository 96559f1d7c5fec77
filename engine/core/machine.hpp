// What a time on this machine is to be read with, and which program took it.
#pragma once
#include <cstdint>
#include <string>

namespace afterglow
{
std::string processorName(); // "CPU" where the system does not say

// Runnable processes, mean of the last minute; 0 where the system does not say.
double machineLoad();

// Bytes of this process that lie in memory, now and at most so far; 0 where the system does not say.
std::uint64_t memoryNow();
std::uint64_t memoryPeak();

// Of this program's code, from its linker: another build has another. Empty where the linker wrote none.
std::string buildId();
}
