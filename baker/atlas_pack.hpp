// Places footprints on the smallest page that holds them, largest first, each in the lowest free spot; a page is a bitmap of texels taken.
#pragma once
#include "baker/atlas_footprint.hpp"
#include <optional>

namespace afterglow
{
struct Packing {
    ivec2 size{0};              // of the page, multiples of its grain
    std::vector<ivec2> origins; // one per footprint, texels
};

// Nothing when they do not fit on a page of limit x limit texels.
std::optional<Packing> pack(const std::vector<const Footprint*>& footprints, int limit, int grain);

double footprintArea(const std::vector<const Footprint*>& footprints); // texels
}
