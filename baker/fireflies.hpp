// Rare light in a lightmap, before it is filtered: a texel that one path made far brighter than those about it would come out of a filter as a
// blot as wide as the filter, at another place for another seed.
#pragma once
#include "baker/islands.hpp"

namespace afterglow
{
// A texel more than kFirefly times as bright as the median of those about it, of its island, while one half of its paths tells no more than
// twice that median, or a sixteenth of its light, takes that neighbour's place. Its light is kept: the whole island is as much brighter, channel by channel. Not where
// more about it are such texels than two paths are shared by: that is an edge of the light; and not in an island of which more than kRare of a
// channel's light is in such texels: there light is rare everywhere, and neighbours say nothing of it.
constexpr float kFirefly = 4.0f, kRare = 0.2f;

// The texels that are one, with the same bounds but for kRare.
std::vector<std::size_t> rareTexels(const Lightmap& lightmap, const TexelGuides& guides, const Islands& islands);

// Returns, for each number of Islands::of, the square of what its light is off by for that, relative: as if the fireflies in each square of
// texels were of one path: those that share paths are such squares, but for borders of charts.
std::vector<float> spreadFireflies(Lightmap& lightmap, TexelGuides& guides, const Islands& islands);
}
