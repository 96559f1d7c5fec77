// Inside of row 6: what a level calls for, effect by effect, before the command line overrules it.
#pragma once
#include "engine/frame/plan.hpp"

namespace afterglow
{
// `reason` says why it is on, or why it is off.
struct Choice {
    bool on = false;
    std::string reason;
};

struct Rule {
    const char* effect;
    Choice (*called)(const std::vector<Need>&, const Evidence&);
    bool always = false; // without it there is no picture: no option turns it off
};

// One for each effect, in the order of the frame.
std::span<const Rule> rules();
}
