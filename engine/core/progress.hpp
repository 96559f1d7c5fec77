// Progress of a long stage, with rate and remaining time: a bar on a terminal, plain lines otherwise, or JSON lines for machines.
#pragma once
#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>

namespace afterglow
{
enum class ProgressStyle { automatic, plain, json, none };

class Progress
{
public:
    explicit Progress(ProgressStyle style);
    void begin(const std::string& stage, std::uint64_t units, const std::string& unitName);
    void advance(std::uint64_t units); // from any thread
    void end();
    bool interrupted() const; // Ctrl-C was pressed: stop at the next unit, leave nothing half-written

private:
    void print(bool final);
    ProgressStyle style_;
    std::string stage_, unit_;
    std::uint64_t total_ = 0;
    std::atomic<std::uint64_t> done_{0};
    std::atomic<std::int64_t> printedAt_{0}; // ms since begin
    std::chrono::steady_clock::time_point began_;
};
}
