// Places footprints on a page, largest first, each turned by quarters so that it reaches the least high; a page is a bitmap of texels taken.
#pragma once
#include "baker/atlas_footprint.hpp"
#include <optional>

namespace afterglow
{
struct Spot {
    ivec2 origin{0}; // texels
    int turns = 0;   // counter-clockwise quarters of the footprint, about its own corner
};

struct Packing {
    ivec2 size{0};           // of the page, multiples of its grain
    std::vector<Spot> spots; // one per footprint
};

// On the smallest page; nothing when they do not fit on one of limit x limit texels.
std::optional<Packing> pack(const std::vector<const Footprint*>& footprints, int limit, int grain);

// On a page of this width that grows as high as it must: in the first of several orders that is no higher than `enough`, or in the best of them.
Packing packUpwards(const std::vector<const Footprint*>& footprints, int width, int enough);

double footprintArea(const std::vector<const Footprint*>& footprints); // texels
}
