// Takes the noise out of a lightmap page without taking its edges: of several smooth fits to each texel's neighbourhood those count which one
// half of the texel's paths makes and the other half confirms.
#pragma once
#include "baker/islands.hpp"
#include "engine/core/progress.hpp"

namespace afterglow
{
// Filters the texels of islands, each with others of its own; the rest is neither read nor changed. Biased by no more than what the halves
// cannot tell from noise. An island keeps its light: what one path brought that was far brighter than all others is spread, not lost.
// Directions go with their light. Texels of a single path have no halves, and stay. Variances become those
// that are left.
void denoise(Lightmap& lightmap, TexelGuides& guides, const Islands& islands, int threads,
             const Advance& advance = unheard); // in denoiseRows()

std::uint64_t denoiseRows(int height); // of all its passes over a page of that many rows
}
