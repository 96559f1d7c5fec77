// Progress of a long stage, with rate and remaining time: a bar on a terminal, plain lines otherwise, or JSON lines for machines.
// Between begin() and end() Ctrl-C is an Error at the stage's next step (interrupt.hpp).
#pragma once
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

namespace afterglow
{
enum class ProgressStyle { automatic, plain, json, none };

// How the work of a stage tells what is done, from any thread, without knowing of bars and lines.
using Advance = std::function<void(std::uint64_t units)>;
inline void unheard(std::uint64_t) {}

class Progress
{
public:
    explicit Progress(ProgressStyle style);
    ~Progress();
    Progress(const Progress&) = delete;
    void begin(const std::string& stage, std::uint64_t units, const std::string& unitName);
    void advance(std::uint64_t units); // from any thread
    void end();

private:
    void print(bool final);
    ProgressStyle style_;
    bool within_ = false; // a stage
    std::string stage_, unit_;
    std::uint64_t total_ = 0;
    std::atomic<std::uint64_t> done_{0};
    std::atomic<std::int64_t> printedAt_{0}; // ms since begin
    std::chrono::steady_clock::time_point began_;
};
}
