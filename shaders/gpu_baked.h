// The baked level as shaders see it: engine/upload/gpu_baked.cpp fills these from engine/baked, shaders/bindings.glsl declares them.
#ifndef AFTERGLOW_GPU_BAKED_H
#define AFTERGLOW_GPU_BAKED_H
#include "shaders/probe.h"
#include "shaders/reflection.h"
SHARED_BEGIN

// The tree of probes lies in texels as in its files (engine/baked/probes.hpp), with positions in m in the place of parts of a box.
const int kTexelsOfProbe = 9;
const int kTexelsOfNode = 2;
const int kTexelsOfCell = 4;

// An even grid of boxes, the outermost of which reach to infinity. Each names what of the tree lies in it (engine/upload/probe_grid.cpp).
struct ProbeGrid {
    vec3 lower;    // m
    vec3 perMetre; // boxes
    ivec3 size;    // boxes
    int firstCell; // where the cells lie among the tree's texels
};

FN int probeGridPlace(float at, int size)
{
    return at > 0.0f ? int(min(at, float(size - 1))) : 0; // no NaN gets past this comparison
}

// The box that holds a point: x before y before z.
FN int probeGridBox(IN(ProbeGrid) grid, vec3 position)
{
    vec3 at = (position - grid.lower) * grid.perMetre;
    return probeGridPlace(at.x, grid.size.x) +
           grid.size.x * (probeGridPlace(at.y, grid.size.y) + grid.size.y * probeGridPlace(at.z, grid.size.z));
}

// The split-sum table: n.v across, perceptual roughness down, 0 and 1 at the centres of the outermost texels.
const int kSplitSumSize = 32;
FN vec2 splitSumUv(float mu, float roughness)
{
    return (clamp(vec2(mu, roughness), 0.0f, 1.0f) * float(kSplitSumSize - 1) + 0.5f) / float(kSplitSumSize);
}

SHARED_END
#endif
