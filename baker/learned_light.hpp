// Light for probes alone to look up: where no lightmap is made, texels of one are traced by few paths (learnLight()), and nobody gets
// them. Medium without a cache and with, CPU s: gallery (reference), all direct light, 164 (at 5 % between probes) and 75 (at 4 %);
// two_rooms_open 39 and 7, cornell 12 and 4.7, pool 15 and 18.
#pragma once
#include "baker/baker.hpp"
#include <tuple>

namespace afterglow
{
// Paths of each texel: a quarter of a lightmap's. Gallery: with an eighth the noise of probes is half as much again, with a half no less.
int learnedOf(Quality quality);

// Texels per metre: no finer than lightmaps, and with a tenth of the paths at most that probes are reckoned to take. With half of them the
// gallery's probes are no better, and the still life's take twice as long. 0: they would be too coarse, and probes trace their own paths.
float learnedDensity(const Scene& scene, const BakeOptions& made, double area);

// What charts change of a level, and have to give back.
using Uncharted = std::tuple<std::vector<Vertex>, std::vector<uint>, std::vector<Mesh>, std::vector<Object>, std::vector<std::string>>;
inline auto chartedOf(Scene& scene) { return std::tie(scene.vertices, scene.indices, scene.meshes, scene.objects, scene.warnings); }
}
