// How visible the seams of a level's lightmaps are: by how much a display's value steps where one chart ends and the next begins.
#pragma once
#include "baker/seam_texels.hpp"

namespace afterglow
{
// How a level's surfaces are shown, were they white.
struct Shown {
    float exposure = 1.0f;
    uint curve = 0;                      // kTone... of shaders/color.h
    float operator()(float light) const; // code of a display, 0 to 255, not rounded
    vec3 operator()(vec3 light) const { return {(*this)(light.x), (*this)(light.y), (*this)(light.z)}; }
};

// As the level says, or with middle grey for its mean light: of the logarithm, over measured texels.
Shown shownAs(const Display& display, const std::vector<Lightmap>& pages);

// Bilinear, as the runtime's sampler reads it: in rgb9e5, whatever the page's file holds, and without mips, for it makes none of lightmaps.
vec3 lookup(const Lightmap& page, vec2 at);

// Differences of the two lookups at the points of all seams, the largest of the channels, in steps of a display of 8 bits;
// black on both sides, or as bright as can be, is none of them.
struct SeamSteps {
    double mean = 0.0, most = 0.0, worst = 0.0; // `most`: what 95 % of the length of all seams stay below
};
SeamSteps stepsOf(const std::vector<Lightmap>& pages, const Seams& seams, const Shown& shown);
}
