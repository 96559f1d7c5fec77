// What a draw of the level's surfaces pushes, for every pass that rasterises them with surface.vert.
#ifndef AFTERGLOW_SURFACE_PUSH_H
#define AFTERGLOW_SURFACE_PUSH_H
#include "shaders/scene.h"
SHARED_BEGIN

// 128 bytes, all that Vulkan promises: a draw needs nothing else, so no vertex gathers its instance.
struct SurfacePush {
    mat4 objectToClip;  // multiplied in double on the CPU
    mat3 objectToWorld; // linear part: normals go by its cofactors, tangents by itself
    vec2 lightmapScale;
    vec2 lightmapOffset;
    uint material;
    uint page;   // of the lightmap, kGBufferNoPage: none; and kPushMirrored
    uint object; // index of the placed mesh in the level
};

// Beside the page: what this surface mirrors is drawn by an eye behind it (GBufferTexel::mirrored).
const uint kPushMirrored = 256u;
FN uint pushedPage(uint page) { return page & (kPushMirrored - 1u); }
FN uint pushedMirrored(uint page) { return page / kPushMirrored; }

// Cofactors of m: its inverse transpose up to the determinant's factor, which normalize removes (m never mirrors), and finite for any m.
FN mat3 cofactors(mat3 m) { return mat3(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])); }

SHARED_END
#endif
