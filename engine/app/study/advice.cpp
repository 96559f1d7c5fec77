#include "engine/app/study/advice.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace afterglow
{
namespace
{
constexpr double kMuch = 1.25; // times: what is worth a word
constexpr double kSome = 1.03; // times: what is a difference at all

std::string spoken(const Sweep& sweep, const Point& point) { return sweep.knob + " " + point.name; }

std::string cost(const Curve& curve, const Point& point)
{
    return spokenTime(point.ms) + " for an error of " + spokenError(curve.sweep, point.error);
}

std::string timesTheError(double times)
{
    return times > kSome || times * kSome < 1.0 ? fmt::format("{:.2g} times the error", times) : "the same error";
}

std::string ofDrawn(const Curve& curve)
{
    const Point &off = curve.points.front(), &on = curve.points.back();
    const std::string price = on.ms > off.ms + on.spread + off.spread ? fmt::format("It costs {} of a frame", spokenTime(on.ms - off.ms))
                                                                      : std::string("Its cost is lost in the noise of the frame's time");
    const std::string errors =
        fmt::format("{} without it, {} with it", spokenError(curve.sweep, off.error), spokenError(curve.sweep, on.error));
    if (on.error * kMuch < off.error) return fmt::format("{}, and the picture needs it: the error is {}.", price, errors);
    if (on.error * kSome < off.error) return fmt::format("{}, and brings the picture a little nearer to the truth: {}.", price, errors);
    return fmt::format("{}; from this camera it brings the picture no nearer to the truth: {}.", price, errors);
}

// The best that the chart has instead of `point`: no slower and no worse, and much better in one of the two.
const Point* better(const Curve& own, const Point& point, const std::vector<const Curve*>& chart, const Curve*& whose)
{
    const Point* best = nullptr;
    for (const Curve* curve : chart)
        for (const Point& other : curve->points) {
            if (curve == &own && &other > &point) continue; // more of the same is not less: the clock scatters
            if (!(other.ms <= point.ms && other.error <= point.error)) continue;
            if (!(other.ms * kMuch < point.ms || other.error * kMuch < point.error)) continue;
            if (!best || other.error < best->error) best = &other, whose = curve;
        }
    return best;
}
}

std::string spokenTime(double ms)
{
    if (ms >= 999.5) return fmt::format("{:.3g} s", 1e-3 * ms);
    return fmt::format("{:.3g} ms", ms);
}

std::string spokenPrice(const Sweep& sweep, double ms)
{
    if (sweep.clock != Clock::cpuRays && sweep.clock != Clock::gpuRays) return spokenTime(ms);
    if (ms < 999.5) return fmt::format("{:.3g} ns", ms);
    return ms < 999500.0 ? fmt::format("{:.3g} us", 1e-3 * ms) : fmt::format("{:.3g} ms", 1e-6 * ms);
}

std::string spokenError(const Sweep& sweep, double error)
{
    if (sweep.held == Held::hits) return std::isnan(error) ? "-" : fmt::format("{:.2g} %", 100.0 * error);
    if (error == 0.0) return "less than can be told";
    const bool relative = sweep.held != Held::visibility && !sweep.displayed;
    return relative ? fmt::format("{:.{}f} %", 100.0 * error, error < 0.01 ? 2 : error < 0.1 ? 1 : 0) : fmt::format("{:.2g}", error);
}

std::string adviceOf(const Curve& curve, const std::vector<const Curve*>& chart)
{
    if (curve.points.empty()) return "";
    if (curve.sweep.knob == kDrawn) return ofDrawn(curve);
    const auto standard = std::find_if(curve.points.begin(), curve.points.end(), [](const Point& p) { return p.standard; });
    if (standard == curve.points.end()) return "";
    if (std::all_of(curve.points.begin(), curve.points.end(), [](const Point& p) { return p.error == 0.0; }))
        return "Nothing that can be told changes with it here: the level says it itself, or shows nothing of it from this camera.";
    const std::string now = fmt::format("The default, {}, costs {}", spoken(curve.sweep, *standard), cost(curve, *standard));
    const Curve* whose = nullptr;
    if (const Point* other = better(curve, *standard, chart, whose))
        return fmt::format("{}; {} is better here: {}.", now, spoken(whose->sweep, *other), cost(*whose, *other));
    std::string text = now;
    if (standard != curve.points.begin()) {
        const Point& less = *std::prev(standard);
        if (less.ms * kMuch < standard->ms && less.error > 0.0)
            text += fmt::format("; {} saves {:.0f} % of the time for {}", spoken(curve.sweep, less), 100.0 * (1.0 - less.ms / standard->ms),
                                timesTheError(less.error / std::max(standard->error, 1e-9)));
        else
            text += fmt::format("; {} saves little", spoken(curve.sweep, less));
    }
    if (std::next(standard) != curve.points.end()) {
        const Point& more = *std::next(standard);
        if (more.error * kMuch < standard->error)
            text += fmt::format("; {} takes {:.2g} times the time for {:.2g} of the error", spoken(curve.sweep, more),
                                std::max(more.ms / std::max(standard->ms, 1e-9), 1.0), more.error / standard->error);
        else
            text += fmt::format("; {} gains little", spoken(curve.sweep, more));
    }
    return text + ".";
}
}
