#include "engine/core/progress.hpp"
#include "engine/core/forecast.hpp"
#include "engine/core/interrupt.hpp"
#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

namespace afterglow
{
Progress::Progress(ProgressStyle style) : style_(style)
{
    if (style == ProgressStyle::automatic && isatty(STDERR_FILENO) == 0) style_ = ProgressStyle::plain; // automatic: a bar from here on
    hearInterrupts();
}

// A stage that failed leaves its bar; what is said next begins on a line of its own.
Progress::~Progress()
{
    if (within_ && style_ == ProgressStyle::automatic) std::fputc('\n', stderr);
    endInterruptible();
}

void Progress::plan(std::vector<StageForecast> stages) { stages_ = std::move(stages); }

void Progress::begin(const std::string& stage, std::uint64_t units, const std::string& unitName)
{
    beginInterruptible();
    within_ = true;
    stage_ = stage;
    unit_ = unitName;
    worked_ = found_ = 0;
    costly_ = 0;
    printedAt_ = 0;
    began_ = std::chrono::steady_clock::now();
    expect(units);
}

void Progress::expect(std::uint64_t units)
{
    total_ = units;
    for (StageForecast& stage : stages_)
        if (stage.name == stage_) afterglow::expect(stage, weigh(units));
}

void Progress::costlyFirst(std::uint64_t units, double times)
{
    costly_ = units, times_ = times;
    expect(total_);
}

// The first so many units, in the time of a later one.
double Progress::weigh(std::uint64_t units) const { return double(units) + (times_ - 1.0) * double(std::min(units, costly_)); }

static std::int64_t msSince(std::chrono::steady_clock::time_point began)
{
    return std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - began).count();
}

// How often a line is worth its ink, ms.
static std::int64_t interval(ProgressStyle style)
{
    switch (style) {
    case ProgressStyle::automatic:
        return 100;
    case ProgressStyle::json:
        return 1000;
    default:
        return 5000;
    }
}

void Progress::advance(std::uint64_t units) { add(worked_, units); }

void Progress::find(std::uint64_t units) { add(found_, units); }

void Progress::add(std::atomic<std::uint64_t>& count, std::uint64_t units)
{
    count += units;
    if (style_ == ProgressStyle::none) return;
    std::int64_t before = printedAt_;
    const std::int64_t now = msSince(began_);
    if (now - before >= interval(style_) && printedAt_.compare_exchange_strong(before, now)) print(/* final= */ false);
}

void Progress::end()
{
    if (style_ != ProgressStyle::none) print(/* final= */ true);
    stages_ = stagesAt(double(msSince(began_)) * 1e-3);
    for (StageForecast& stage : stages_) stage.over = stage.over || stage.name == stage_;
    stopIfInterrupted();
    within_ = false;
    endInterruptible();
}

// With what the stage has done in its time so far.
std::vector<StageForecast> Progress::stagesAt(double seconds) const
{
    std::vector<StageForecast> stages = stages_;
    for (StageForecast& stage : stages)
        if (stage.name == stage_)
            stage.found = weigh(found_), stage.worked = weigh(worked_ + found_) - stage.found, stage.seconds = seconds;
    return stages;
}

static std::string duration(double seconds)
{
    const auto whole = std::uint64_t(seconds + 0.5);
    if (whole < 60) return fmt::format("{:.1f} s", seconds);
    if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

static std::string quantity(double count)
{
    if (count >= 1e9) return fmt::format("{:.2f} G", count * 1e-9);
    if (count >= 1e6) return fmt::format("{:.2f} M", count * 1e-6);
    if (count >= 1e4) return fmt::format("{:.1f} k", count * 1e-3);
    return fmt::format("{:.{}f} ", count, count < 10 ? 1 : 0);
}

void Progress::print(bool final)
{
    const std::uint64_t worked = worked_, found = found_, done = worked + found, total = std::max(total_, done);
    const double seconds = double(msSince(began_)) * 1e-3;
    const double rate = seconds > 0 ? double(worked) / seconds : 0;                                           // units / s; 0: not known yet
    const double eta = rate > 0 ? seconds * (weigh(total) - weigh(done)) / (weigh(done) - weigh(found)) : -1; // s; -1: not known yet
    const double all = stages_.empty() ? eta : secondsLeft(stagesAt(seconds));                                // s, of all stages
    const double share = total > 0 ? double(done) / double(total) : 1.0;

    std::string line;
    if (style_ == ProgressStyle::json) {
        const auto known = [](double time) { return time >= 0 ? fmt::format("{:.3f}", time) : "null"; };
        line = fmt::format(
            R"({{"stage":"{}","done":{},"total":{},"unit":"{}","rate":{},"seconds":{:.3f},"eta_s":{},"all_seconds":{:.3f},"all_eta_s":{}}})",
            stage_, done, total, unit_, rate > 0 ? fmt::format("{:.6g}", rate) : "null", seconds, known(eta), double(msSince(made_)) * 1e-3,
            known(all));
        line += '\n';
    } else {
        const std::string speed = rate > 0 ? fmt::format(", {}{}/s", quantity(rate), unit_) : "";
        std::string time = final ? ", " + duration(seconds) : eta >= 0 ? ", " + duration(eta) + " left" : "";
        if (!final && eta >= 0 && !stages_.empty()) time += ", " + duration(all) + " in all";
        if (style_ == ProgressStyle::plain) {
            line = fmt::format("{}: {:3.0f} % ({} of {} {}{}{})\n", stage_, 100 * share, done, total, unit_, speed, time);
        } else {
            constexpr int width = 30;
            const int filled = int(share * width);
            line = fmt::format("\r{:12} [{}{}] {:3.0f} %{}{}\x1b[K{}", stage_, std::string(filled, '#'), std::string(width - filled, '.'),
                               100 * share, speed, time, final ? "\n" : "");
        }
    }
    std::fwrite(line.data(), 1, line.size(), stderr); // one write: lines of several threads do not mix
    std::fflush(stderr);
}
}
