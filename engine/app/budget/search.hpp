// The best frame for a time, of frames that are seen: never worse, by the same measure, than the default frame at the largest size that
// fits.
#pragma once
#include "engine/app/budget/propose.hpp"

namespace afterglow
{
// How a frame is looked at; each choice once.
struct Trials {
    std::function<double(const Choice&)> error; // squared
    std::function<double(const Choice&)> ms;
};

struct Tried {
    Choice choice;
    Price seen;
    bool fits = false;
};

struct Found {
    Tried best;  // what fits with the least error; where nothing does, see search.cpp
    Tried plain; // the default settings, at the largest size that fits, or at the smallest
};

// `ms`: what is left of the budget by its margin.
Found search(const Curves& curves, double ms, const Trials& trials);
constexpr double kMargin = 0.1; // of the budget, left for what clocks scatter by
constexpr int kMostTrials = 16; // of a search, about
}
