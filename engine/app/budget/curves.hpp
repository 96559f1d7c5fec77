// What the options of a frame cost and are off by, measured here and kept for the next time: in $XDG_CACHE_HOME/afterglow, else
// ~/.cache/afterglow. The folder may be removed at any time. What one run has no time for, the next ones measure.
#pragma once
#include "engine/app/budget/look.hpp"
#include "engine/app/budget/options.hpp"

namespace afterglow
{
// Drawn at a share of width and height.
struct Scale {
    double scale = 1.0;
    double share = 1.0; // of the time of the default frame
    double error = 0.0; // what it adds, squared
};

struct Curves {
    double medianMs = 0.0;        // of the default frame
    double ms = 0.0, error = 0.0; // of the default frame: GPU, undisturbed; squared
    std::vector<Group> groups;    // with their prices, the default's 0 first; only options that pay: neither slower nor worse than another
    std::vector<Scale> scales = {Scale{}}; // rising; the last is the default
    Truth truth;                           // small: path traced; of a style, drawn at rest
    std::size_t unmeasured = 0;            // options that there was no time for
};

// What is known is taken from the cache, what is not is measured, in about kLongest at most. Throws Error.
Curves curvesOf(const Sitter& sitter, std::vector<Group> offered, ProgressStyle progress);
constexpr double kLongest = 120.0; // s, after the truth and the default frame

constexpr double kRounding = 0.01; // of the default frame's time and error: what clock and noise do not tell

// Of options whose prices are measured: those that no other is at least as fast and as good as, to a hundredth of the default frame. The
// default stays the first.
void keepWhatPays(Group& group, double ms, double error);
}
