// Carries light to where none was measured: into the padding around charts, so that filtering never meets a texel without data.
#pragma once
#include "baker/owners.hpp"

namespace afterglow
{
// Fills texels without data from the mean of their neighbours with data, ring after ring; baked texels never change. A chart's texels take
// from their own chart alone, and all of them are filled if it has any light of its own: black where it is dark, whoever lies beside it on
// the page. Nobody's get `rings` rings, for samplers that read further than the runtime's.
void dilate(Lightmap& lightmap, const std::vector<uint>& owner, int rings = 4); // owner: Owners::texelOf of the page
}
