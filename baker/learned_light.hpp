// Light for probes alone to look up: where no lightmap is made, texels of one are traced by few paths (learnLight()), and nobody gets
// them. Medium without a cache and with, all direct light, CPU s: gallery (reference) 216 and 62, two_rooms_open 42 and 6.4, cornell 21 and
// 5.9; pool 13 and 16.
#pragma once
#include "baker/baker.hpp"
#include <tuple>

namespace afterglow
{
// Paths of each texel: a quarter of a lightmap's. Gallery: with an eighth the noise of probes is half as much again, with a half no less.
int learnedOf(Quality quality);

// Texels per metre: no finer than lightmaps, and with two fifths of the least paths that probes are expected to take. With five times as
// many the gallery's probes are no better, and the still life's take twice as long. 0: too coarse, and probes trace their own paths.
float learnedDensity(const Scene& scene, const BakeOptions& made, double area);

// What charts change of a level, and have to give back.
using Uncharted = std::tuple<std::vector<Vertex>, std::vector<uint>, std::vector<Mesh>, std::vector<Object>, std::vector<std::string>>;
inline auto chartedOf(Scene& scene) { return std::tie(scene.vertices, scene.indices, scene.meshes, scene.objects, scene.warnings); }
}
