// The level's meshes with a vertex for each chart that uses it, and uv1 where the atlas put it.
#pragma once
#include "baker/atlas_unwrap.hpp"

namespace afterglow
{
// Per unwrapped mesh: uv1 = (origin of its chart + turned corner) / size, texels.
struct ChartPlaces {
    std::vector<Spot> spots; // per chart
    ivec2 size{1};           // of the page, or of the mesh's own rectangle
};

// Replaces the scene's vertices and indices; triangles keep their order, meshes that are not unwrapped keep their vertices.
void rewriteMeshes(Scene& scene, const std::vector<UnwrappedMesh>& meshes, const std::vector<ChartPlaces>& places);
}
