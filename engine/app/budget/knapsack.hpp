// One option of each group, so that together they fit and are the best that fits: the multiple-choice knapsack, solved exactly.
// Based on: Nemhauser & Ullmann 1969 (partial choices that another one beats in both price and error are dropped).
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

namespace afterglow
{
// What an option adds to the sum; either may be negative.
struct Price {
    double ms = 0.0, error = 0.0;
};

// The index of each group's choice: sum of ms at most `budget`, sum of errors the least; of equal errors, the fastest. Nothing when even
// the fastest do not fit. Groups have at least one option each.
std::optional<std::vector<std::size_t>> chooseWithin(const std::vector<std::vector<Price>>& groups, double budget);
}
