// Progress of a long stage, with rate and remaining time, its own and that of all stages that are planned: a bar on a terminal, plain lines
// otherwise, or JSON lines for machines.
// Between begin() and end() Ctrl-C is an Error at the stage's next step (interrupt.hpp).
#pragma once
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace afterglow
{
enum class ProgressStyle { automatic, plain, json, none };

// How the work of a stage tells what is done, from any thread, without knowing of bars and lines.
using Advance = std::function<void(std::uint64_t units)>;
inline void unheard(std::uint64_t) {}

struct StageForecast; // forecast.hpp

class Progress
{
public:
    explicit Progress(ProgressStyle style);
    ~Progress();
    Progress(const Progress&) = delete;
    void plan(std::vector<StageForecast> stages); // that will begin, by name
    void begin(const std::string& stage, std::uint64_t units, const std::string& unitName);
    void expect(std::uint64_t units);                    // of the stage, now that more is known; while no other thread works
    void costlyFirst(std::uint64_t units, double times); // of the stage: so many take that many times as long as all later ones
    void advance(std::uint64_t units);                   // from any thread
    void find(std::uint64_t units);                      // done before: they say nothing of the rate
    void end();

private:
    void add(std::atomic<std::uint64_t>& count, std::uint64_t units);
    double weigh(std::uint64_t units) const;
    std::vector<StageForecast> stagesAt(double seconds) const;
    void print(bool final);
    ProgressStyle style_;
    bool within_ = false; // a stage
    std::string stage_, unit_;
    std::uint64_t total_ = 0, costly_ = 0; // units; the first of them that cost more
    double times_ = 1.0;                   // as much as later ones
    std::atomic<std::uint64_t> worked_{0}, found_{0};
    std::vector<StageForecast> stages_;      // planned
    std::atomic<std::int64_t> printedAt_{0}; // ms since begin
    std::chrono::steady_clock::time_point began_, made_ = std::chrono::steady_clock::now();
};
}
