// Which options are measured first, for there may be no time for all: what no pipeline must be compiled for, of the effects that take the
// most time, from the far ends of each knob. Where a far end changes nothing, what lies between does not either and is left out.
#pragma once
#include "engine/app/budget/options.hpp"
#include <map>

namespace afterglow
{
struct Place {
    std::size_t group = 0, option = 0;
    bool operator==(const Place&) const = default;
};

// `shares`: of the frame's time, by effect.
std::vector<Place> queueOf(const std::vector<Group>& groups, const std::map<std::string, double>& shares);

// Whether the nearest options of its knob that are measured, one to each side (the default is one), are within `close` in error of each
// other.
bool liesBetween(const Group& group, const Option& option, const std::map<std::string, double>& errors, double close);
}
