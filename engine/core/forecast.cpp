#include "engine/core/forecast.hpp"
#include <algorithm>

namespace afterglow
{
// What is reckoned weighs as much as this share of a stage's units.
static constexpr double kReckoned = 0.01;

// Stages of less than this, in s, say little of the machine.
static constexpr double kTooShort = 0.1;

// What stages have taken, by what they were reckoned to take.
static double slowness(const std::vector<StageForecast>& stages, const Tempo* tempo)
{
    double taken = 0.0, reckoned = 0.0;
    for (const StageForecast& stage : stages) {
        if (tempo && stage.tempo != *tempo) continue;
        taken += stage.seconds;
        reckoned += stage.worked * stage.cost;
    }
    return reckoned > 0.0 || !tempo ? (taken + kTooShort) / (reckoned + kTooShort) : slowness(stages, nullptr);
}

void expect(StageForecast& stage, double units)
{
    if (stage.units == 1.0 && units > 0.0) stage.cost /= units;
    stage.units = units;
}

double secondsLeft(const std::vector<StageForecast>& stages)
{
    double seconds = 0.0;
    for (const StageForecast& stage : stages) {
        const double left = stage.units - stage.worked - stage.found, weight = kReckoned * stage.units;
        if (stage.over || !(left > 0.0)) continue;
        seconds += left * (stage.seconds + weight * stage.cost * slowness(stages, &stage.tempo)) / (stage.worked + weight);
    }
    return seconds;
}
}
