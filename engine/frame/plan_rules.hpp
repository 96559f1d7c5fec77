// Inside of row 6: what a level calls for, effect by effect, before the command line overrules it.
#pragma once
#include "engine/frame/plan.hpp"

namespace afterglow
{
// `reason` says why it is on, or why it is off.
struct Ruling {
    bool on = false;
    std::string reason;
};

// What a rule goes by. `on`: whether another effect is drawn in the end, whatever the command line says; rules never ask in a circle.
struct Question {
    const std::vector<Need>& needs;
    const Evidence& level;
    const Overrides& overrides;
    bool on(std::string_view effect) const;
};

struct Rule {
    const char* effect;
    Ruling (*called)(const Question&);
    bool always = false; // without it there is no picture: no option turns it off
};

// One for each effect, in the order of the frame.
std::span<const Rule> rules();
}
