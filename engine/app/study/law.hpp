// What a row of numbers says: its middle and its spread, the power law that it follows, and which of its points are worth having.
#pragma once
#include "engine/app/study/study.hpp"

namespace afterglow
{
struct Quartiles {
    double median = 0.0, spread = 0.0; // spread: interquartile range
};
Quartiles quartiles(std::vector<double> values);

// Least squares in log-log over (value, error), both positive. A floor is assumed only where one may be and explains the curve: when it at
// least halves what a straight line leaves over. Nothing for fewer than three points.
enum class Floor { some, none };
std::optional<Fit> fitLaw(const std::vector<std::pair<double, double>>& points, Floor floor = Floor::some);

// Marks the points that no other is at least as fast and as accurate as.
void markPareto(const std::vector<Point*>& points);

// "expected steps^-1, measured ^-0.96 over a factor of 32", and whether that is within kSlopeSlack, or below the most that is allowed.
std::string verdictOf(const Law& law, const std::string& knob, const std::optional<Fit>& fit);
constexpr double kSlopeSlack = 0.15; // of a slope, over at least
constexpr double kSlopeRange = 16.0; // in the knob, before a law is said to hold
}
