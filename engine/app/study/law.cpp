#include "engine/app/study/law.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace afterglow
{
// Between two neighbours where the place falls between them.
static double quantile(const std::vector<double>& sorted, double share)
{
    const double at = share * double(sorted.size() - 1);
    const std::size_t below = std::size_t(at), above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (sorted[above] - sorted[below]) * (at - double(below));
}

Quartiles quartiles(std::vector<double> values)
{
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    const double lower = quantile(values, 0.25);
    return {lower, quantile(values, 0.5), quantile(values, 0.75) - lower};
}

namespace
{
struct Trial {
    Fit fit;
    double left = std::numeric_limits<double>::infinity(); // sum of squares of what the logarithms are off by
};

// For a given slope and floor / factor the best factor is the mean of what it would have to be.
Trial tryLaw(const std::vector<std::pair<double, double>>& points, double slope, double floorShare)
{
    std::vector<double> factors;
    double mean = 0.0;
    for (const auto& [value, error] : points) {
        factors.push_back(std::log(error) - 0.5 * std::log(floorShare * floorShare + std::pow(value, 2.0 * slope)));
        mean += factors.back() / double(points.size());
    }
    Trial trial{{slope, std::exp(mean), std::exp(mean) * floorShare, 1.0}, 0.0};
    for (double factor : factors) trial.left += (factor - mean) * (factor - mean);
    return trial;
}
}

std::optional<Fit> fitLaw(const std::vector<std::pair<double, double>>& points, Floor floor)
{
    constexpr double kSteepest = 4.0, kStep = 0.01;
    constexpr int kFloors = 60;          // tried, from 1e-2 to 1e2 times what the law leaves at its smallest
    constexpr double kExplained = 0.5;   // of what a straight line leaves over
    constexpr double kStraight = 0.0025; // what a straight line may leave over per point: 5 % each
    if (points.size() < 3) return {};
    double least = points[0].first, most = points[0].first;
    for (const auto& [value, error] : points) {
        if (!(value > 0.0) || !(error > 0.0)) return {};
        least = std::min(least, value), most = std::max(most, value);
    }
    if (!(most > least)) return {};

    Trial line, bent;
    for (double slope = -kSteepest; slope <= kSteepest; slope += kStep) {
        if (const Trial trial = tryLaw(points, slope, 0.0); trial.left < line.left) line = trial;
        const double smallest = std::min(std::pow(least, slope), std::pow(most, slope)); // of value^slope
        for (int i = 0; i < kFloors; ++i) {
            const double share = smallest * std::pow(10.0, -2.0 + 4.0 * i / (kFloors - 1));
            if (const Trial trial = tryLaw(points, slope, share); trial.left < bent.left) bent = trial;
        }
    }
    const bool straight = floor == Floor::none || line.left < kStraight * double(points.size()) || points.size() < 4;
    Trial best = !straight && bent.left < kExplained * line.left ? bent : line;
    if (std::abs(best.fit.slope) < 0.5 * kStep) best.fit.slope = 0.0;
    best.fit.range = most / least;
    return best.fit;
}

double toldError(const Point& point) { return std::max(point.error, point.noise); }

void markPareto(const std::vector<Point*>& points)
{
    for (Point* point : points)
        point->pareto = std::none_of(points.begin(), points.end(), [&](const Point* other) {
            const double error = toldError(*point), others = toldError(*other);
            return other->ms <= point->ms && others <= error && (other->ms < point->ms || others < error);
        });
}

std::string spokenValue(double value) { return std::abs(value) >= 1000.0 ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value); }

std::string verdictOf(const Law& law, const std::string& knob, const std::optional<Fit>& fit)
{
    std::string text;
    if (law.slope) text = fmt::format("expected {}{}^{:.3g}", law.most ? "below " : "", knob, *law.slope);
    if (law.text[0]) text += (text.empty() ? "" : ", ") + std::string(law.text);
    if (!fit) return text;
    text += fmt::format("{}measured {}^{:.2g} over a factor of {}", text.empty() ? "" : "; ", knob, fit->slope, spokenValue(fit->range));
    if (fit->floor > 0.0) text += fmt::format(", down to a floor of {:.2g}", fit->floor);
    if (!law.slope) return text;
    const bool close = law.most ? fit->slope < *law.slope : std::abs(fit->slope - *law.slope) <= kSlopeSlack;
    if (close && fit->range < kSlopeRange) return text + ": as expected, over a short range";
    return text + (close ? ": the law holds" : ": the law does not show here");
}
}
