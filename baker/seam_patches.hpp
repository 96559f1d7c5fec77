// Seams fall apart into patches that share no texel: each is stitched by itself. Answers "who has to agree with whom?".
#pragma once
#include "baker/seam_texels.hpp"

namespace afterglow
{
struct SeamPatch {
    std::vector<uint> points, texels; // of Seams, ascending
    // What the lookups at each point touch; Weighted::texel counts in `texels`
    std::vector<std::array<Weighted, 4>> side[2];
};

// By their first points; texels that no point touches are in none.
std::vector<SeamPatch> seamPatches(const Seams& seams);
}
