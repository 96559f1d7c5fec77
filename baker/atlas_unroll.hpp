// Joins neighbouring charts where the two unroll as one: the quarters of a cylinder, the strips of a cone.
// This work is based on: a local/global approach to mesh parameterization (Liu, Zhang, Xu, Gotsman, Gortler 2008), as rigid as possible.
#pragma once
#include "baker/atlas_flatten.hpp"

namespace afterglow
{
struct UnrollOptions {
    double texel = 1.0 / 16; // m: folds are sought at half of it
    double longest = 100.0;  // m: no joined chart gets longer
};

// The same triangles in fewer charts, or as many. `across`: as Charts has it.
std::vector<FlatChart> unroll(const Surface& surface, const std::vector<uint>& across, std::vector<FlatChart> charts,
                              const UnrollOptions& options);
}
