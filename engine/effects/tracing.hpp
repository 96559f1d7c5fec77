// What every pass needs that traces rays through the level (shaders/trace.glsl).
#pragma once
#include "engine/graph/graph.hpp"
#include "engine/upload/gpu_scene.hpp"
#include "shaders/ray_scene.h"

namespace afterglow
{
inline Pass& traces(Pass& pass, const GpuRays& rays)
{
    return pass.specialize(kTraceFiltered, rays.filtered).specialize(kTraceTinted, rays.tinted);
}
}
