// A lightmap page as textures: colour, beside it the coverage, so that black light and no light stay apart, and, where a level calls for
// it, the direction. Each is a file of its own: whoever wants the colour alone reads a plain texture and no more.
#pragma once
#include "engine/baked/baked.hpp"
#include "engine/baked/ktx2.hpp"

namespace afterglow
{
// Irradiance / pi: rgb9e5, or rgba32f where a value is beyond its range.
Ktx2 lightmapTexture(const Lightmap& page);

// R8, of the same size: 255 baked, 128 dilated, 0 outside every chart.
Ktx2 coverageTexture(const Lightmap& page);

// (d, a) of shaders/lightmap.h, half floats: a + d.N = 1 to 2^-11 of |a| + |d|.
Ktx2 directionTexture(const Lightmap& page);

// Throws Error when the two are not a page. `what` names the colour's file.
Lightmap readLightmap(const Ktx2& texture, const Ktx2& coverage, const std::string& what);

void readDirection(const Ktx2& texture, Lightmap& page, const std::string& what);

// The page as a picture, for masters: exact to half floats.
Image lightmapImage(const Lightmap& page);
}
