// Takes the noise out of a lightmap page without taking its edges: each texel is averaged with neighbours on the same surface whose light
// differs by no more than their noise explains.
#pragma once
#include "engine/baked/baked.hpp"
#include "engine/core/progress.hpp"
#include <functional>
#include <vector>

namespace afterglow
{
// What the filter is guided by, one entry per texel of the page.
struct TexelGuides {
    std::vector<vec3> position;  // world, m
    std::vector<vec3> normal;    // unit shading normal
    std::vector<float> variance; // of the texel's mean luminance, measured from its samples
};

// Whether nothing opaque stands between two points of a surface, at that height over it.
using Sight = std::function<bool(vec3 from, vec3 to, vec3 height)>;

// The island of each texel, numbered from 1 in row order; 0: it is not baked. Baked texels that touch, by an edge or a corner, are of one.
struct Islands {
    std::vector<int> of;
    int count = 0;
};
Islands islandsOf(const Lightmap& lightmap);

// Filters baked texels (valid = 1), each with others of its island; the rest is neither read nor changed. Biased where light changes within
// its noise. Texels swap light in pairs: the sum over an island stays what it was, and what one path brought that was far brighter than
// all others is spread, not lost. Directions go with their light. A texel that no path brought light to
// stays black unless it sees one with light.
void denoise(Lightmap& lightmap, const TexelGuides& guides, const Sight& sight, int threads,
             const Advance& advance = unheard); // in denoiseRows()

std::uint64_t denoiseRows(int height); // of all its passes over a page of that many rows
}
