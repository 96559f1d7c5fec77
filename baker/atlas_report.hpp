// How well the pages are used, and how truly: measured on the finished scene.
#pragma once
#include "baker/atlas.hpp"

namespace afterglow
{
AtlasReport measureAtlas(const Scene& scene, const std::vector<LightmapPlace>& places, const std::vector<ivec2>& pageSizes, int charts);
}
