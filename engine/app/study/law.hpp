// What a row of numbers says: its middle and its spread, the power law that it follows, and which of its points are worth having.
#pragma once
#include "engine/app/study/study.hpp"

namespace afterglow
{
struct Quartiles {
    double lower = 0.0, median = 0.0, spread = 0.0; // lower: a quarter is below; spread: from there to where a quarter is above
};
Quartiles quartiles(std::vector<double> values);

// Least squares in log-log over (value, error), both positive. A floor is assumed only where one may be and explains the curve: when it at
// least halves what a straight line leaves over. Nothing for fewer than three points.
enum class Floor { some, none };
std::optional<Fit> fitLaw(const std::vector<std::pair<double, double>>& points, Floor floor = Floor::some);

// The error, or the least that can be told where it is not above that.
double toldError(const Point& point);

// Marks the points that no other is at least as fast and as accurate as.
void markPareto(const std::vector<Point*>& points);

// 0.125, 16, 1024: three digits, or all before the point.
std::string spokenValue(double value);

// "expected steps^-1, measured ^-0.96 over a factor of 32", and whether that is within kSlopeSlack, or below the most that is allowed.
std::string verdictOf(const Law& law, const std::string& knob, const std::optional<Fit>& fit);
constexpr double kSlopeSlack = 0.15; // of a slope, over at least
constexpr double kSlopeRange = 16.0; // in the knob, before a law is said to hold
}
