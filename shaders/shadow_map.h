// Raster shadow maps: what a map is, which of a light's maps a point falls into, and how far a caster must be pushed back.
#ifndef AFTERGLOW_SHADOW_MAP_H
#define AFTERGLOW_SHADOW_MAP_H
#include "shaders/reflection.h"
#include "shaders/scene.h"
SHARED_BEGIN

// One map: a square of the atlas, seen from a light. Depth is reversed: 1 nearest to the light.
struct ShadowView {
    mat4 worldToClip;
    vec2 scale; // atlas uv = map uv * scale + offset
    vec2 offset;
    float inset;   // of the map's uv: half the filter's width, so that a filter never reaches into a neighbour
    vec2 rounding; // the reference depth is raised by x * depth + y, see below
};

// A surface square to the light has no slope to push it back: what is left is the rounding of the point and of two matrix products, some
// 1e-6 of the distances involved. A perspective's depth is relative, near / distance; an orthographic one is a share of its box.
const float kShadowRounding = 3e-5f;
FN vec2 perspectiveRounding() { return vec2(kShadowRounding, 0.0f); }
FN vec2 orthographicRounding() { return vec2(0.0f, kShadowRounding); }

// Half the width of the filter in texels: two bilinear comparisons across, half a texel to each side.
const float kShadowRadius = 1.5f;

// Least offset in m along the light that keeps a plane from shadowing itself (King 2004): a map whose texels are `texel` m wide at the
// receiver, a plane inclined by theta to the map, a filter of k texels' radius. On a diagonal slope times sqrt(2).
FN float shadowBias(float texel, float tanTheta, float k) { return (k + 0.5f) * texel * tanTheta; }

// Which face of a point light's cube the direction away from the light falls into: +x -x +y -y +z -z.
FN uint shadowFace(vec3 fromLight) { return uint(cubeFace(fromLight).z); }

SHARED_END
#endif
