// Ambient occlusion by one of several methods, all of which answer with the same texture: visibility of the light from everywhere, R16F at
// the picture's resolution, 1 = open (the sky, too), 0 = hidden. It covers every pixel; lighting takes it where no lightmap holds it.
#pragma once
#include "engine/effects/occlusion/occlusion.h"
#include "engine/effects/view.hpp"
#include "engine/upload/gpu_voxels.hpp"

namespace afterglow
{
enum class OcclusionMethod {
    automatic, // hbao
    ssao,      // points of the hemisphere against the depth buffer
    hbao,      // horizons in the depth buffer, closed form between them
    voxel,     // cones through the level's voxels: what the screen does not see hides, too
    ray        // ray queries, where the device has them
};

// What the methods know of the level beside the picture, each its own; they must outlive the run.
struct Occluders {
    const GpuVoxels& voxels; // voxel; without any, nothing is hidden
    const GpuRays& rays;     // ray; without any, by hbao
};

// `mapped`: of surfaces whose lightmap holds their contact, too; without them, they are said to be open, and cost nothing.
Texture occlusion(Graph& graph, const View& view, const GBuffer& surfaces, const Occluders& level, OcclusionMethod method,
                  const OcclusionParameters& parameters, bool mapped = true);
}
