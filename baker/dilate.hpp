// Carries the light of baked texels into the padding around their charts, so that filtering never meets a texel without data.
#pragma once
#include "engine/baked/baked.hpp"

namespace afterglow
{
// Fills texels without data from the mean of their neighbours with data, ring after ring; baked texels never change.
void dilate(Lightmap& lightmap, int rings = 4);
}
