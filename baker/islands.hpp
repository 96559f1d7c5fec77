// What a filter of a lightmap page goes by, and which of its texels lie on one piece of one surface, so that it may mix them.
#pragma once
#include "engine/baked/baked.hpp"
#include <functional>
#include <vector>

namespace afterglow
{
class World;

// One entry per texel of the page.
struct TexelGuides {
    std::vector<vec3> position;  // world, m
    std::vector<vec3> normal;    // unit shading normal
    std::vector<vec3> half;      // half of what the means of the two halves of its paths differ by
    std::vector<float> variance; // of the mean: its luminance's, after the filter that of one channel
};

constexpr float kMuch = 4.0f; // the ratio of light from which a wall may part texels side by side

constexpr float kSightHeight = 0.25f; // of the way between two texels: so far above the surface they look across

// Whether nothing opaque stands between two points of a surface, at that height over it; world, m.
using Sight = std::function<bool(vec3 from, vec3 to, vec3 height)>;
Sight sightIn(const World& world); // which outlives it

// The island of each texel, numbered from 1 in row order; 0: it is not baked.
struct Islands {
    std::vector<int> of;
    int count = 0;
};

// Whether light may pass between two texels that touch, of these numbers.
using Joined = std::function<bool(std::size_t here, std::size_t there)>;

// Baked texels (valid = 1) that touch by an edge or a corner are of one island, those that are not joined only if others lead round.
Islands islandsOf(const Lightmap& lightmap, const Joined& joined);

// Neighbours whose light differs much are of one island only if they see each other: a shadow's edge is crossed, a wall's foot is not.
Islands islandsOf(const Lightmap& lightmap, const TexelGuides& guides, const Sight& sight);
}
