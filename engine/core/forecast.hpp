// How long a command of several stages still takes: what was reckoned beforehand, put right by what the stages have cost so far.
#pragma once
#include <string>
#include <vector>

namespace afterglow
{
// What the time of a stage goes with. How fast one of its kind went says how fast the others will go.
enum class Tempo { machine, light };

struct StageForecast {
    std::string name;
    double units = 0.0; // 1: reckoned as a whole, and shared out over its units once they are known
    double cost = 1.0;  // s of a unit, reckoned: of stages of one kind, only how they are to one another matters
    Tempo tempo = Tempo::machine;
    double worked = 0.0, seconds = 0.0; // units that took these seconds
    double found = 0.0;                 // units that were there already
    bool over = false;
};

// The stage begins, or more is known of it: its units.
void expect(StageForecast& stage, double units);

// Seconds of all stages together, from here on.
double secondsLeft(const std::vector<StageForecast>& stages);
}
