// Nets of charts: numbered by what corners share, and sewn together.
#pragma once
#include "baker/atlas_rigid.hpp"
#include "baker/sets.hpp"
#include <utility>

namespace afterglow
{
// Ids from 0 for the sets of corners, as they come in `order`, which has one of each; points as the mean of their corners'.
void number(Net& net, Sets& sets, const std::vector<dvec2>& corners, const std::vector<uint>& order);

// Both in one net, where `ends` are pairs of corners, one of each net, that become one point. `from` is moved so that its ends lie on those of
// `into`: the nearest motion, without a mirror.
Net sewn(const Net& into, const Net& from, const std::vector<std::pair<uint, uint>>& ends);
}
