// Ambient occlusion: which share of the light from everywhere reaches a point, weighted by the cosine; a surface farther than `range`
// hides nothing. 1: open, 0: hidden.
#ifndef AFTERGLOW_OCCLUSION_EFFECT_H
#define AFTERGLOW_OCCLUSION_EFFECT_H
#include "engine/effects/depth_apart.h"
#include "shaders/gbuffer.h"
SHARED_BEGIN

struct OcclusionParameters {
    float range;    // m
    uint divisor;   // looked for at this fraction of the picture's resolution: 1 or 2
    uint slices;    // hbao: planes through the line of sight, 1..16; 16 neighbours turn them between each other
    uint steps;     // hbao: to each side of a slice
    uint samples;   // ssao: points of the hemisphere
    uint cones;     // voxel
    float aperture; // voxel: tangent of half a cone's angle
    uint rays;      // ray: of a pixel
    uint smooth_;   // 1: the 16 neighbours are averaged along their surface
    uint denoise;   // ray: 1: they are filtered by the noise of their rays instead; in a frame the plan says so
};
FN OcclusionParameters defaultOcclusionParameters()
{
    OcclusionParameters p;
    p.range = 1.0f;
    p.divisor = 2u;
    p.slices = 2u;
    p.steps = 6u;
    p.samples = 16u;
    p.cones = 8u;
    p.aperture = 0.1f;
    p.rays = 8u;
    p.smooth_ = 1u;
    p.denoise = 0u;
    return p;
}

struct OcclusionFrame {
    mat4 pixelToEye; // (x, y, depth, 1) -> place relative to the eye, in the world's axes; x, y: index of a pixel
    mat4 eyeToClip;
    vec4 eye;        // w = 0, orthographic: xyz is the direction towards the eye
    vec2 metres;     // as depthApart() takes them
    ivec2 size;      // of the picture, px
    vec3 voxelLower; // m, relative to the eye
    float voxelEdge; // m, of a voxel of mip 0
    OcclusionParameters p;
};

struct OcclusionDenoise {
    float frames; // that the picture is the mean of
};
const uint kFewestFiltered = 8u; // README: of fewer rays the mean of the neighbours is nearer
const uint kOcclusionNoise = 2u; // specialization constant: the noise of the rays is told, too

// What the pass that traces rays knows beside it.
struct OcclusionTrace {
    vec3 eye; // world: what OcclusionFrame counts from
    uint seed;
};

const uint kOcclusionMapped = 1u; // specialization constant: of surfaces with a lightmap, too, which holds what hides them
FN bool asksForOcclusion(uvec4 surface) { return (surface.w >> 24u) >= kGBufferBackPage; }
const uint kOcclusionVoxelMips = 0u; // specialization constant; 0: the level has no voxels

// The part of a slice that lies between the line of sight and its horizon, weighted by the cosine to the normal and by the sine that the
// slices' turn about the line of sight brings. Angles from the line of sight, of one sign on one side: h of the horizon, n of the normal
// as it is seen in the slice. Based on: Jimenez et al. 2016, "Practical Real-Time Strategies for Accurate Indirect Occlusion".
FN float horizonArc(float h, float n) { return 0.25f * (cos(n) - cos(2.0f * h - n) + 2.0f * h * sin(n)); }
// Both sides of a slice whose horizons are those of the surface itself: h = n +- pi / 2.
FN float openArc(float n) { return cos(n) + n * sin(n); }

SHARED_END
#endif
