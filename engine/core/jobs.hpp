// Work on several threads whose result does not depend on how many: each index is a pure function of itself.
#pragma once
#include <cstddef>
#include <functional>

namespace afterglow
{
// Calls work(i) for every i in [0, count) on up to `threads` threads (0: all cores), in no stated order; FTZ and DAZ are set in each of
// them. The first exception thrown by a call is rethrown here after the others have stopped; Ctrl-C within a stage is one (interrupt.hpp).
void parallelFor(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

// The number of threads that `threads` asks for: itself, or the machine's cores for 0.
int threadCount(int threads);
}
