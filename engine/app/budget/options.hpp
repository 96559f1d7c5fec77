// What a frame can be drawn with instead: for each effect of its plan the other settings of the study's knobs, and leaving it out.
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
    double scale = 1.0;                    // of width and height: the group "upscale"
    Price price;                           // of a frame with this alone changed, beyond the default's; the error squared
};

struct Group {
    std::string effect;
    std::vector<Option> options; // the first is the default
};

// Effects that the command line names keep what it says: by name, or by a knob that it turned. So do styles and bloom, which stand for no truth, shapes, and
// what the bake holds, which costs little to look up.
std::vector<Group> optionsFor(const Plan& plan, const Settings& settings, bool rayQuery);
}
