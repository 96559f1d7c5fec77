// The march of a ray through a pyramid of depths: in the picture a ray is a straight line, and so is its reversed depth along it.
// The includer defines, before this line:
//   struct DepthPyramid                                    where the depths lie, passed by value
//   vec2  depthRange(DepthPyramid, int level, ivec2 cell)  reversed depths of a square of 2^level px: x nearest (greatest), y farthest
//   float depthBetween(DepthPyramid, vec2 at)              reversed depth at a place of the picture, px, linear between centres
// This work is based on: Uludag 2014, "Hi-Z Screen-Space Cone-Traced Reflections" (GPU Pro 5).
#ifndef AFTERGLOW_MARCH_H
#define AFTERGLOW_MARCH_H
#include "shaders/camera.h"
SHARED_BEGIN

// From where it leaves the surface to where it leaves the picture: x, y in px from the top left, z reversed depth.
struct ScreenRay {
    vec3 from;
    vec3 to;
};

// How deep a surface is taken to be behind what the picture shows of it.
struct Thickness {
    float share;  // of the distance to the eye, of a perspective
    float depths; // in reversed depth, of an orthographic eye
};
FN float backOf(float depth, Thickness t) { return depth / (1.0f + t.share) - t.depths; }

struct March {
    uint steps;      // cells at most
    uint bisections; // of the cell in which the ray meets the surface
    int levels;      // of the pyramid
    Thickness thickness;
};

struct MarchHit {
    float along;  // 0..1 of the screen ray; 1: nothing met
    float behind; // 0: it lies on the surface; 1: as far behind it as the surface is thick
    uint steps;   // cells visited
};

FN vec3 alongRay(ScreenRay ray, float along) { return ray.from + (ray.to - ray.from) * along; }
FN vec3 screenPoint(vec4 clip, vec2 size) { return vec3(ndcToUv(vec2(clip) / clip.w) * size, clip.z / clip.w); }

// Clipped by the picture's borders, by the near plane and by infinity. Homogeneous: clip(s) = (1 - s) * origin + s * direction, where
// s = 1 lies infinitely far, so that no distance is ever chosen; each plane is linear in s, and the origin lies inside of all of them.
FN ScreenRay makeScreenRay(mat4 worldToClip, vec3 origin, vec3 direction, vec2 size)
{
    vec4 a = worldToClip * vec4(origin, 1.0f);
    vec4 b = worldToClip * vec4(direction, 0.0f);
    float end = 1.0f;
    for (int plane = 0; plane < 6; ++plane) {
        int axis = plane / 2;
        float inA = a.w + (plane % 2 == 0 ? a[axis] : -a[axis]), inB = b.w + (plane % 2 == 0 ? b[axis] : -b[axis]);
        if (plane == 4) { // the sky: depth 0 rather than -1
            inA = a.z;
            inB = b.z;
        }
        if (inB < 0.0f) end = min(end, max(inA, 0.0f) / (max(inA, 0.0f) - inB));
    }
    ScreenRay ray;
    ray.from = screenPoint(a, size);
    ray.to = screenPoint(a * (1.0f - end) + b * end, size);
    return ray;
}

FN float boundaryAhead(float from, float step_, float at, float cell)
{
    float boundary = (floor(at / cell) + (step_ > 0.0f ? 1.0f : 0.0f)) * cell;
    return step_ != 0.0f ? (boundary - from) / step_ : kFloatMax;
}

// The first place where the ray lies behind the picture's surface, and not farther than its thickness.
FN MarchHit march(DepthPyramid pyramid, ScreenRay ray, March how)
{
    const float kNudge = 0.02f; // px beyond a cell's border, so that rounding never keeps the ray in the cell that it left
    const float kStart = 1.0f;  // px: the ray's own pixel is not asked
    MarchHit hit;
    hit.along = 1.0f;
    hit.behind = 1.0f;
    hit.steps = 0u;
    vec3 d = ray.to - ray.from;
    float pixels = max(abs(d.x), abs(d.y));
    if (!(pixels > kStart)) return hit; // straight at the eye, or away from it: it never leaves its pixel
    float nudge = kNudge / pixels, along = kStart / pixels;
    int level = 0;
    for (; hit.steps < how.steps && along < 1.0f; ++hit.steps) {
        float cell = float(1 << level);
        vec3 p = alongRay(ray, along);
        ivec2 at = ivec2(int(floor(p.x / cell)), int(floor(p.y / cell)));
        float leaves = min(boundaryAhead(ray.from.x, d.x, p.x, cell), boundaryAhead(ray.from.y, d.y, p.y, cell));
        leaves = clamp(leaves, along, 1.0f);
        float depthOut = ray.from.z + d.z * leaves;
        vec2 range = depthRange(pyramid, level, at);
        // At the finest level the depth is that of the pixel's centre: asked there, or a slope seen edge-on would hide itself
        float farthest = level == 0 ? 0.5f * (p.z + depthOut) : min(p.z, depthOut);
        // A pixel ago the ray may still have been before the surface that it is far behind now: that is no hidden hit. Nor is it one where
        // the surface itself comes nearer by as much from pixel to pixel
        float nearest = max(depthOut, p.z - d.z / pixels), back = backOf(range.y, how.thickness), slope = 0.0f;
        if (level == 0 && farthest <= range.x && nearest < range.x) {
            vec3 ago = p - d / pixels, next = p + d / pixels;
            slope = min(abs(depthRange(pyramid, 0, ivec2(int(floor(ago.x)), int(floor(ago.y)))).x - range.x),
                        abs(depthRange(pyramid, 0, ivec2(int(floor(next.x)), int(floor(next.y)))).x - range.x));
        }
        if (farthest > range.x || nearest < back - slope || !(range.x > 0.0f)) {
            along = leaves + nudge;
            level = min(level + 1, how.levels - 1);
            continue;
        }
        if (level > 0) {
            --level;
            continue;
        }
        // Behind the pixel: is it behind the surface between the pixels too?
        vec3 out_ = alongRay(ray, leaves);
        if (out_.z > depthBetween(pyramid, vec2(out_))) {
            along = leaves + nudge;
            continue;
        }
        float before = max(along - 1.0f / pixels, 0.0f), after = leaves;
        for (uint k = 0u; k < how.bisections; ++k) {
            float half_ = 0.5f * (before + after);
            vec3 q = alongRay(ray, half_);
            if (q.z > depthBetween(pyramid, vec2(q)))
                before = half_;
            else
                after = half_;
        }
        hit.along = after;
        hit.behind = clamp((range.x - slope - nearest) / max(range.x - back, 1e-12f), 0.0f, 1.0f);
        return hit;
    }
    return hit;
}

SHARED_END
#endif
