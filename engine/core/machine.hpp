// What a time on this machine is to be read with, and which program took it.
#pragma once
#include <string>

namespace afterglow
{
std::string processorName(); // "CPU" where the system does not say

// Runnable processes, mean of the last minute; 0 where the system does not say.
double machineLoad();

// Of this program's code, from its linker: another build has another. Empty where the linker wrote none.
std::string buildId();
}
