#include "engine/app/study/advice.hpp"
#include "engine/app/study/law.hpp"
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
    return spokenTime(point.ms) + " for an error of " + spokenError(curve.sweep, point);
}

// Whether the truth's noise leaves it to be told that the one is farther from the truth.
bool isWorse(const Point& a, const Point& b)
{
    const double noise = std::max(a.noise, b.noise);
    return a.error > b.error && a.error * a.error - b.error * b.error > noise * noise;
}

std::string timesTheTime(double times)
{
    return times > kSome || times * kSome < 1.0 ? fmt::format("takes {:.2g} times the time", times) : "takes as long";
}

std::string timesTheError(const Point& other, const Point& standard)
{
    if (!isWorse(other, standard) && !isWorse(standard, other)) return "an error that cannot be told from it";
    if (!(toldError(standard) > 0.0)) return "an error where there was none";
    if (!(toldError(other) > 0.0)) return "no error: its picture is the truth";
    const double times = toldError(other) / toldError(standard);
    return times > kSome || times * kSome < 1.0 ? fmt::format("{:.2g} times the error", times) : "the same error";
}

std::string ofDrawn(const Curve& curve)
{
    const Point &off = curve.points.front(), &on = curve.points.back();
    const std::string price = on.ms > off.ms + on.spread + off.spread ? fmt::format("It costs {} of a frame", spokenTime(on.ms - off.ms))
                                                                      : std::string("Its cost is lost in the noise of the frame's time");
    const std::string errors = fmt::format("{} without it, {} with it", spokenError(curve.sweep, off), spokenError(curve.sweep, on));
    if (isWorse(off, on) && on.error * kMuch < off.error)
        return fmt::format("{}, and the picture needs it: the error is {}.", price, errors);
    if (isWorse(off, on) && on.error * kSome < off.error)
        return fmt::format("{}, and brings the picture a little nearer to the truth: {}.", price, errors);
    if (isWorse(on, off) && off.error * kSome < on.error)
        return fmt::format("{}, and from this camera the picture is worse with it: {}.", price, errors);
    return fmt::format("{}; from this camera nothing can be told of what it brings: {}.", price, errors);
}

// The best that the chart has instead of `point`: no slower and no worse, and much better in one of the two.
const Point* better(const Curve& own, const Point& point, const std::vector<const Curve*>& chart, const Curve*& whose)
{
    const Point* best = nullptr;
    for (const Curve* curve : chart)
        for (const Point& other : curve->points) {
            // More of the same is not less: the clock scatters. Options without an order are
            if (curve == &own && &other > &point && own.sweep.names.empty()) continue;
            if (!(other.ms <= point.ms) || isWorse(other, point)) continue;
            if (!(other.ms * kMuch < point.ms || (isWorse(point, other) && other.error * kMuch < point.error))) continue;
            if (!best || isWorse(*best, other)) best = &other, whose = curve;
        }
    return best;
}

// Of values without an order, each.
std::string ofOther(const Curve& curve, const Point& other, const Point& standard)
{
    return fmt::format("; {} {} for {}", spoken(curve.sweep, other), timesTheTime(other.ms / std::max(standard.ms, 1e-9)),
                       timesTheError(other, standard));
}

std::string ofLess(const Curve& curve, const Point& less, const Point& standard)
{
    const std::string name = spoken(curve.sweep, less);
    if (less.ms * kMuch < standard.ms)
        return fmt::format("; {} saves {:.0f} % of the time for {}", name, 100.0 * (1.0 - less.ms / standard.ms),
                           timesTheError(less, standard));
    if (less.ms <= standard.ms && less.error <= standard.error && isWorse(standard, less))
        return fmt::format("; {} is a little faster and better: {}", name, cost(curve, less));
    if (isWorse(less, standard) && less.error > kSome * standard.error) return fmt::format("; {} saves little and is worse", name);
    return fmt::format("; {} saves little", name);
}

std::string ofMore(const Curve& curve, const Point& more, const Point& standard)
{
    const std::string name = spoken(curve.sweep, more);
    if (isWorse(standard, more) && more.error * kMuch < standard.error) return ofOther(curve, more, standard);
    if (isWorse(more, standard) && more.error > kSome * standard.error)
        return fmt::format("; {} is worse: {}", name, spokenError(curve.sweep, more));
    if (!isWorse(standard, more) && standard.error > 0.0 && std::max(standard.noise, more.noise) > 0.0)
        return fmt::format("; what {} gains cannot be told", name);
    if (more.ms <= standard.ms && isWorse(standard, more)) return fmt::format("; {} is no slower and a little better", name);
    return fmt::format("; {} gains little", name);
}
}

std::string spokenTime(double ms)
{
    if (ms >= 999.5) return fmt::format("{:.3g} s", 1e-3 * ms);
    return fmt::format("{:.3g} ms", ms);
}

std::string spokenBytes(double bytes)
{
    return bytes >= 999500.0 ? fmt::format("{:.3g} MB", 1e-6 * bytes) : fmt::format("{:.3g} kB", 1e-3 * bytes);
}

std::string spokenPrice(const Sweep& sweep, double ms)
{
    if (sweep.clock != Clock::cpuRays && sweep.clock != Clock::gpuRays) return spokenTime(ms);
    if (ms < 999.5) return fmt::format("{:.3g} ns", ms);
    return ms < 999500.0 ? fmt::format("{:.3g} us", 1e-3 * ms) : fmt::format("{:.3g} ms", 1e-6 * ms);
}

// With as many digits as make it none but 0.
static std::string spokenNumber(const Sweep& sweep, double error)
{
    if (sweep.held == Held::visibility || sweep.displayed) return fmt::format("{:.2g}", error);
    if (error < 5e-6) return "below 0.001 %";
    return fmt::format("{:.{}f} %", 100.0 * error, error < 0.00005 ? 3 : error < 0.01 ? 2 : error < 0.1 ? 1 : 0);
}

std::string spokenError(const Sweep& sweep, const Point& point)
{
    if (sweep.held == Held::hits) return std::isnan(point.error) ? "-" : fmt::format("{:.2g} %", 100.0 * point.error);
    if (point.error > point.noise) return spokenNumber(sweep, point.error);
    return point.noise > 0.0 ? fmt::format("less than can be told (noise {})", spokenNumber(sweep, point.noise)) : "less than can be told";
}

std::string adviceOf(const Curve& curve, const std::vector<const Curve*>& chart)
{
    if (curve.points.empty()) return "";
    const Point &first = curve.points.front(), &last = curve.points.back();
    if (curve.sweep.knob == kDrawn) return ofDrawn(curve);
    if (curve.sweep.exact)
        return fmt::format("Off by {} at {}, and by {} at {}.", spokenError(curve.sweep, first), first.name, spokenError(curve.sweep, last),
                           last.name);
    const auto standard = std::find_if(curve.points.begin(), curve.points.end(), [](const Point& p) { return p.standard; });
    if (standard == curve.points.end()) return "";
    if (std::all_of(curve.points.begin(), curve.points.end(), [](const Point& p) { return p.error <= p.noise; }))
        return first.noise > 0.0
                   ? "No error here is above the noise of what it is held against."
                   : "Nothing that can be told changes with it here: the level says it itself, or shows nothing of it from this camera.";
    const std::string now = fmt::format("The default, {}, costs {}", spoken(curve.sweep, *standard), cost(curve, *standard));
    const Curve* whose = nullptr;
    if (const Point* other = better(curve, *standard, chart, whose))
        return fmt::format("{}; {} is better here: {}.", now, spoken(whose->sweep, *other), cost(*whose, *other));
    std::string text = now;
    if (!curve.sweep.names.empty()) {
        for (const Point& other : curve.points)
            if (&other != &*standard) text += ofOther(curve, other, *standard);
        return text + ".";
    }
    if (standard != curve.points.begin()) text += ofLess(curve, *std::prev(standard), *standard);
    if (std::next(standard) != curve.points.end()) text += ofMore(curve, *std::next(standard), *standard);
    return text + ".";
}
}
