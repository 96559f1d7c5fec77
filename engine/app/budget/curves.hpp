// What the options of a frame cost and are off by, measured here and kept for the next time: in $XDG_CACHE_HOME/afterglow, else
// ~/.cache/afterglow. The folder may be removed at any time.
#pragma once
#include "engine/app/budget/options.hpp"
#include "engine/app/level.hpp"
#include "engine/app/study/studio.hpp"

namespace afterglow
{
// A frame to be measured: of which level, by which settings.
struct Sitter {
    const Target& target;
    std::filesystem::path path; // of the target
    Setup setup;                // its camera and size are the frame's
    Executor& executor;
};

// As a command asks for it.
Setup setupOf(const Settings& settings, const Camera& camera);

struct Curves {
    double ms = 0.0, error = 0.0; // of the default frame: GPU, median; squared
    std::vector<Group> groups;    // with their prices, the default's 0 first; only options that pay: neither slower nor worse than another
    Truth truth;                  // small: path traced; of a style, drawn at rest
    std::size_t skipped = 0;      // options that there was no time to measure
};

// From the cache, or measured in about kLongest at most. Throws Error.
Curves curvesOf(const Sitter& sitter, std::vector<Group> offered, ProgressStyle progress);
constexpr double kLongest = 120.0; // s, after the truth; half of it for the errors

// The frame as a moving eye sees it, relative squared error against the truth.
double errorSquaredOf(const Sitter& sitter, const Truth& truth, const Settings& settings);

// Median GPU ms of `frames` frames at the full size.
double frameMs(const Sitter& sitter, const Settings& settings, int frames);

constexpr double kRounding = 0.01; // of the default frame's time and error: what clock and noise do not tell

// Of options whose prices are measured: those that no other is at least as fast and as good as, to a hundredth of the default frame. The
// default stays the first.
void keepWhatPays(Group& group, double ms, double error);
}
