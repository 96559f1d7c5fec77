// Raster shadow maps: what a map is, which of a light's maps a point falls into, and how far off its surface a point must be looked up.
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
    float inset; // of the map's uv: half the filter's width, so that a filter never reaches into a neighbour
    vec2 lift;   // the reference depth is raised by x * depth + y, see below
    vec3 texelX; // a texel across and a texel down, m in the world where clip.w is 1, and clip.w times as wide elsewhere
    vec3 texelY;
    float push; // the furthest that a caster is pushed back along the light, in the same m
};

// A surface square to the light does not rise: what is left is the rounding of the point and of two matrix products, some
// 1e-6 of the distances involved. A perspective's depth is relative, near / distance; an orthographic one is a share of its box.
const float kShadowRounding = 3e-5f;
FN vec2 perspectiveRounding() { return vec2(kShadowRounding, 0.0f); }
FN vec2 orthographicRounding() { return vec2(0.0f, kShadowRounding); }

// Half the width of the filter in texels: two bilinear comparisons across, half a texel to each side.
const float kShadowRadius = 1.5f;

// What keeps a plane from shadowing itself. n: its normal in the map's frame, z towards the light. Within the filter the plane rises by
// r (|n.x| + |n.y|) / n.z texels: so far casters are pushed back, which serves the inner corners of a lit room too. But that has no bounds
// as n.z goes to 0, and what is pushed too far casts no shadow on what it touches: kShadowPush ends it at 80 degrees. What is missing
// beyond, along the light, a point gains by a step off its surface, whose height counts 1 / n.z along the light:
//   h = r (|n.x| + |n.y|) - kShadowPush n.z texels,
// 0 up to 80 degrees and never more than r sqrt(2).
const float kShadowPush = 8.5f; // texels along the light: kShadowRadius tan 80 degrees

// `rise`: of the depth within a texel, over both axes. `furthest`: as ShadowView::lift, for kShadowPush texels.
FN float pushedBack(float depth, float rise, vec2 furthest)
{
    return max(depth - min(kShadowRadius * rise, furthest.x * depth + furthest.y), 0.0f);
}

// m off the surface; `toLight`: from the point to a spot or point light, m, or the unit direction to a sun. w: the point's clip.w.
FN float shadowHeight(ShadowView map, float w, vec3 normal, vec3 toLight)
{
    float missing = kShadowRadius * w * (abs(dot(normal, map.texelX)) + abs(dot(normal, map.texelY)));
    return max(missing - map.push * max(dot(normal, toLight), 0.0f), 0.0f);
}

// The same, and the m that the point may be off its surface, along the shading normal, which normal maps and smooth shading tilt: what
// counts is the height above the face itself. Where the two disagree wildly (a face guessed across a silhouette) it is no more than
// doubled.
FN vec3 shadowLift(ShadowView map, float w, vec3 normal, vec3 face, float off, vec3 toLight)
{
    float height = max(shadowHeight(map, w, normal, toLight), shadowHeight(map, w, face, toLight));
    return normal * ((off + height) / max(dot(normal, face), 0.5f));
}

// Width of the rim of a map that follows the eye, of its half edge, over which it blends into the next.
const float kCascadeBlend = 0.0625f;

// Which face of a point light's cube the direction away from the light falls into: +x -x +y -y +z -z.
FN uint shadowFace(vec3 fromLight) { return uint(cubeFace(fromLight).z); }

SHARED_END
#endif
