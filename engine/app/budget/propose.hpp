// Which options of a frame's effects to try for a time. One of each effect, each priced alone against the default frame; their sum predicts:
//     error^2 = error0^2 + sum of what each adds            ms = (ms0 + sum of what each adds) * (ms at the render scale / ms0)
// for errors of unlike causes add in their squares, and most of a frame's time goes by its pixels. A prediction only proposes: budget.cpp draws
// the frame, what it was off by corrects the next proposal, and what is taken was seen to fit.
#pragma once
#include "engine/app/budget/curves.hpp"

namespace afterglow
{
using Choice = std::vector<std::size_t>; // of each group's options

constexpr const char* kScaled = "upscale"; // the group whose options are sizes

std::size_t scaledGroup(const Curves& curves); // its index; the number of groups where there is none

// Ms of the frame, squared error.
Price predicted(const Curves& curves, const Choice& choice);

// The least error whose predicted time is within `ms`; the fastest where none is.
Choice propose(const Curves& curves, double ms);
}
