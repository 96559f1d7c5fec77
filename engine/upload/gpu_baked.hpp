// What the bake adds, in GPU memory: lightmaps, irradiance probes, reflection probes and the split-sum table that goes with them.
#pragma once
#include "engine/baked/baked.hpp"
#include "engine/gpu/gpu.hpp"
#include "shaders/gpu_baked.h"

namespace afterglow
{
// Which products the plan calls for; the others cost nothing.
struct BakedParts {
    bool lightmaps = true, probes = true, reflections = true, directional = true;
};

struct GpuBaked {
    std::vector<GpuImage> lightmaps;
    std::vector<GpuImage> directions; // one for each lightmap, or none
    GpuBuffer probeTree, probes;      // texels of four floats
    GpuBuffer probeStarts;            // where walks down the tree begin
    GpuBuffer reflectionBoxes;
    std::vector<GpuImage> reflections; // cubes
    GpuImage splitSum;                 // only beside reflections
};

GpuBaked uploadBaked(Gpu& gpu, const Baked& baked, const BakedParts& parts);

// instances(baked.scene), each told its place in the lightmaps.
std::vector<Instance> placedInstances(const Baked& baked);
}
