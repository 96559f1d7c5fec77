// The camera: a reversed depth buffer with no far plane, what its values mean, and mirrors.
// View space looks along -z with +y up; clip space is Vulkan's (y down, depth 0..1): depth = near / distance, 1 at the near plane, 0 in the
// sky.
#ifndef AFTERGLOW_CAMERA_H
#define AFTERGLOW_CAMERA_H
#include "shaders/constants.h"
SHARED_BEGIN

// What a matrix can be built from; ask before building (near 0, a field of view of 0 or 180 degrees, an aspect of 0 have no picture).
FN bool validPerspective(float fovY, float aspect, float near_)
{
    return fovY > 1e-4f && fovY < kPi - 1e-4f && aspect > 0.0f && aspect <= kFloatMax && near_ > 0.0f && near_ <= kFloatMax;
}
FN bool validOrthographic(float height, float aspect, float near_, float far_)
{
    return height > 0.0f && height <= kFloatMax && aspect > 0.0f && aspect <= kFloatMax && abs(near_) <= kFloatMax &&
           abs(far_) <= kFloatMax && near_ < far_;
}

// fovY in radians, near in m; view -> clip.
FN mat4 perspectiveReversed(float fovY, float aspect, float near_)
{
    float focal = 1.0f / tan(0.5f * fovY);
    mat4 m = mat4(0.0f);
    m[0][0] = focal / aspect;
    m[1][1] = -focal;
    m[2][3] = -1.0f;
    m[3][2] = near_;
    return m;
}

// Half extents of the box in m; depth 1 at near, 0 at far; near may be negative (behind the eye).
FN mat4 orthographicReversed(float halfWidth, float halfHeight, float near_, float far_)
{
    mat4 m = mat4(1.0f);
    m[0][0] = 1.0f / halfWidth;
    m[1][1] = -1.0f / halfHeight;
    m[2][2] = 1.0f / (far_ - near_);
    m[3][2] = far_ / (far_ - near_);
    return m;
}

// Depth buffer -> m along the view axis, of a perspective; +inf-like kFloatMax in the sky (depth 0).
FN float depthToDistance(float depth, float near_) { return depth > 0.0f ? near_ / depth : kFloatMax; }
FN float distanceToDepth(float distance_, float near_) { return near_ / distance_; }

// Pixels that `size` m covers, seen square on at `distance_` m, in a picture of `height` pixels: a level of detail is chosen by it.
FN float sizeInPixels(float size, float distance_, float height, float fovY)
{
    return size * height / (2.0f * distance_ * tan(0.5f * fovY));
}

// Picture coordinates (0,0 top left .. 1,1 bottom right) of a clip position, and back to normalised device coordinates.
FN vec2 ndcToUv(vec2 ndc) { return ndc * 0.5f + 0.5f; }
FN vec2 uvToNdc(vec2 uv) { return uv * 2.0f - 1.0f; }

// World position of a depth sample; `clipToWorld` is the inverse of (projection * view). Not for the sky: it has a direction only.
FN vec3 worldFromDepth(vec2 uv, float depth, mat4 clipToWorld)
{
    vec4 p = clipToWorld * vec4(uvToNdc(uv), depth, 1.0f);
    return vec3(p) / p.w;
}

// Unit direction in view space through a picture point, for the given projection's m[0][0] and m[1][1].
FN vec3 viewDirection(vec2 uv, vec2 projectionDiagonal) { return normalize(vec3(uvToNdc(uv) / projectionDiagonal, -1.0f)); }

// Smallest step between neighbouring depths at distance z, in m: b-bit unorm between near and far (1/near - 1/far keeps far = inf), and
// a float32 reversed buffer, whose relative spacing is 2^-24 at worst.
FN float depthStepUnorm(float z, float near_, float far_, float bits) { return z * z * (1.0f / near_ - 1.0f / far_) * exp2(-bits); }
FN float depthStepReversedFloat(float z) { return z * 5.9604645e-8f * 2.0f; }

// Plane n.x = k, n unit.
FN vec3 mirrorPoint(vec3 x, vec3 n, float k) { return x - n * (2.0f * (dot(n, x) - k)); }
FN mat4 mirrorMatrix(vec3 n, float k)
{
    mat4 m = mat4(1.0f);
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) m[c][r] -= 2.0f * n[c] * n[r];
    for (int r = 0; r < 3; ++r) m[3][r] = 2.0f * k * n[r];
    return m;
}

// An oblique near plane. Based on: Lengyel 2005. `plane`: xyz unit normal and w, in the space that `toClip` starts from; kept is the side
// plane . p >= 0. Derivation, for reversed depth: the near plane is where z_clip = w_clip, so the new z is
//   z_clip = w_clip - plane . p / reach,     depth = 1 - (plane . p / w_clip) / reach:
// 1 on the plane, above 1 (clipped) before it, and never below 0 within the picture when reach is the largest plane . p / w_clip there.
// That lies at the end of the view, at one of the picture's corners: the clip points (+-1, +-1, 0, 1), whose w_clip is 1. Of a perspective
// without a far plane they are directions, of an orthographic view points; the same line serves both.
// 0 or less: nothing beyond the plane is in view.
FN float obliqueReach(mat4 clipTo, vec4 plane)
{
    float reach = 0.0f;
    for (int corner = 0; corner < 4; ++corner)
        reach = max(reach, dot(plane, clipTo * vec4((corner & 1) != 0 ? 1.0f : -1.0f, (corner & 2) != 0 ? 1.0f : -1.0f, 0.0f, 1.0f)));
    return reach;
}
FN mat4 obliqueNearPlane(mat4 toClip, vec4 plane, float reach)
{
    mat4 m = toClip;
    for (int c = 0; c < 4; ++c) m[c][2] = toClip[c][3] - plane[c] / reach;
    return m;
}

SHARED_END
#endif
