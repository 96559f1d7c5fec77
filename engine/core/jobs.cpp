#include "engine/core/jobs.hpp"
#include "engine/core/interrupt.hpp"
#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace afterglow
{
// Denormals cost a hundred cycles each and hold no light; elsewhere than on x86 they are left alone. Restores what the thread had.
class FlushedDenormals
{
public:
#if defined(__SSE2__)
    FlushedDenormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040u); } // FTZ is bit 15, DAZ bit 6 of MXCSR
    ~FlushedDenormals() { _mm_setcsr(before_); }

private:
    unsigned before_;
#else
    FlushedDenormals() {}
    ~FlushedDenormals() {}
#endif
};

int threadCount(int threads) { return threads > 0 ? threads : std::max(1, int(std::thread::hardware_concurrency())); }

void parallelFor(std::size_t count, int threads, const std::function<void(std::size_t)>& work)
{
    std::atomic<std::size_t> next{0};
    std::atomic<bool> failed{false};
    std::exception_ptr first;
    std::mutex firstGuard;

    const auto worker = [&] {
        FlushedDenormals flushed;
        for (std::size_t i; !failed && (i = next++) < count;) {
            try {
                stopIfInterrupted();
                work(i);
            } catch (...) {
                std::lock_guard lock(firstGuard);
                if (!first) first = std::current_exception();
                failed = true;
            }
        }
    };

    {
        const std::size_t wanted = std::min(count, std::size_t(threadCount(threads)));
        std::vector<std::jthread> others; // joined at the end of this block; the caller is the first worker
        try {
            while (others.size() + 1 < wanted) others.emplace_back(worker);
        } catch (const std::system_error&) {
            // The system has no more threads to give: those that started do the work.
        }
        worker();
    }
    if (first) std::rethrow_exception(first);
}
}
