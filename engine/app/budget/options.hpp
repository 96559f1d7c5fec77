// What a frame can be drawn with instead: for each effect of its plan the other settings of the study's knobs, and leaving it out. How
// large it is drawn is no option but a share that is free (propose.hpp).
#pragma once
#include "engine/app/budget/knapsack.hpp"
#include "engine/frame/plan.hpp"
#include <functional>
#include <string>

namespace afterglow
{
struct Option {
    std::string name;                      // "steps 4 instead of 16"; "left out"
    std::function<void(Settings&)> choose; // empty: nothing changes
    bool staged = false;                   // a stage of the default serves it
    std::string knob;                      // empty: the default, or leaving out
    int place = 0, standing = -1;          // of its value and of the default's among the knob's, cheapest first; -1: of another method
    int last = 0;                          // place that there is
    Price price;                           // of a frame with this alone changed, beyond the default's; the error squared
};

struct Group {
    std::string effect;
    std::vector<Option> options; // the first is the default
};

// Effects that the command line speaks of keep what it says (Settings::said, --effects). So do styles and bloom, which stand for no truth,
// shapes, and what the bake holds, which costs little to look up.
std::vector<Group> optionsFor(const Plan& plan, const Settings& settings, bool rayQuery);

// Where it is drawn smaller by somebody's leave: nobody said how large.
bool mayBeScaled(const Settings& settings);

constexpr const char* kScaled = "upscale"; // the effect of being drawn smaller
}
