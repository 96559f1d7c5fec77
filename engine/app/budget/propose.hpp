// Which options of a frame's effects to try for a time. One of each effect, each priced alone against the default frame; their sum
// predicts:
//     error^2 = error0^2 + sum of what each adds            ms = (ms0 + sum of what each adds) * (ms at the render scale / ms0)
// for errors of unlike causes add in their squares, and most of a frame's time goes by its pixels. A prediction only proposes: search.cpp
// draws the frame, what it was off by corrects the next proposal, and what is taken was seen to fit.
#pragma once
#include "engine/app/budget/curves.hpp"

namespace afterglow
{
struct Choice {
    std::vector<std::size_t> options; // of each group
    double scale = 1.0;               // of width and height
    auto operator<=>(const Choice&) const = default;
};

// Everything as it is.
Choice plainChoice(const Curves& curves);

// Ms of the frame, squared error.
Price predicted(const Curves& curves, const Choice& choice);

// The same at the largest scale, in steps of a hundredth, that is expected to take no longer; at the smallest where none does.
Choice stretched(const Curves& curves, Choice choice, double ms);

// The least error whose predicted time is within `ms`; where none is, the fastest that is not much worse than everything as it is at the
// smallest scale.
Choice propose(const Curves& curves, double ms);

constexpr double kMuch = 1.25; // times: of a time that is worth a worse picture, and of an error that a faster one is not worth
}
