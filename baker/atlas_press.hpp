// Presses footprints into a page that greedy packing leaves too small: they overlap at first, then move one by one to where they overlap
// least, while pairs that stay in each other's way weigh more and more.
// This work is based on: guided local search over translations (Egeblad, Nielsen, Odgaard 2007), weighted as by Gardeyn and Wauters (2025).
#pragma once
#include "baker/atlas_pack.hpp"
#include <random>

namespace afterglow
{
struct Patience {
    int moves;             // of one footprint, that are left
    std::mt19937 random{}; // of the order in which they move
};

// `from`: where they stand first, at will beyond the page and over each other. Nothing when some still overlap after the last try, or there
// are too many.
std::optional<std::vector<Spot>> press(const std::vector<const Footprint*>& footprints, std::vector<Spot> from, ivec2 page,
                                       Patience& patience);
}
