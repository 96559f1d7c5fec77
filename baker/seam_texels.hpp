// The texels that lookups on seams touch: how well the light of each is known, and at which points of a seam light may differ from one side
// to the other after all.
#pragma once
#include "baker/denoise.hpp"
#include "baker/seams.hpp"
#include "baker/solids.hpp"
#include <array>
#include <utility>

namespace afterglow
{
struct SeamTexel {
    uint page, texel;      // in row order
    float share = 0.0f;    // of its area that its chart covers
    bool measured = false; // it has light of its own; otherwise it is a dilated one
    vec3 position{0.0f};   // world, m: mean of where its light was measured
    vec3 normal{0.0f};     // unit
    float variance = 0.0f; // of its luminance
    float spread = 0.0f;   // half of the largest difference between its luminance and that of a neighbour of its chart
    float bend = 0.0f;     // the largest difference between its luminance and the mean of two neighbours on opposite sides

    std::pair<uint, uint> place() const { return {page, texel}; }
};

struct Seams {
    std::vector<ivec2> pageSizes; // texels
    std::vector<SeamPoint> points;
    std::vector<SeamTexel> texels; // ascending by place()
};

// A texel of a bilinear lookup.
struct Weighted {
    std::size_t texel;
    float weight;
};
std::array<Weighted, 4> footprint(ivec2 pageSize, vec2 at);              // texels of the page, as a sampler clamps it
std::array<Weighted, 4> footprint(const Seams& seams, const Lookup& at); // of Seams::texels

Seams findSeams(const World& world, const std::vector<LightmapPlace>& places, const std::vector<ivec2>& pageSizes, int threads);

// Takes what is known of a page's texels, while its guides are there: before it is dilated. `owner`: Owners::texelOf of the page.
void remember(Seams& seams, uint page, const Lightmap& lightmap, const TexelGuides& guides, const std::vector<uint>& owner);

// Leaves out points on one side of which no light was measured, those that something stands upon or hides, and those about which the
// surface turns too much for texels to tell: light differs there. How many of the last there were.
std::size_t dropParted(Seams& seams, const Sight& sight, const Solids& solids, int threads);
}
