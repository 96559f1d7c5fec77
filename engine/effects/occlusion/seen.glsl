// What the passes that look for occluders share: the point under a pixel, its normals, the turn that tells neighbours apart, and what they
// leave: visibility, the depth of the pixel looked at and its slope, by which the next passes know which surface it speaks of.
#ifndef AFTERGLOW_SEEN_GLSL
#define AFTERGLOW_SEEN_GLSL
#include "engine/effects/occlusion/occlusion.h"
#include "engine/effects/slope.glsl"
#include "engine/effects/turn.h"
#include "engine/effects/view_ray.h"

layout(constant_id = kOcclusionMapped) const bool kMapped = true;

layout(set = 1, binding = 0, scalar) uniform Occlusion { OcclusionFrame frame; };
layout(set = 1, binding = 1) uniform usampler2D surfaceTexture;
layout(set = 1, binding = 2) uniform sampler2D depthTexture;

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 seen; // visibility, depth, its slope a pixel in x and y

struct SeenPoint {
    ivec2 pixel;
    vec3 position; // relative to the eye, world's axes
    vec3 normal;   // shading normal
    vec3 face;     // of the surface itself, as its depth says
    vec3 toEye;
    float depth;
    vec2 slope; // of the depth
};

float depthAt(ivec2 pixel) { return texelFetch(depthTexture, pixel, 0).r; }

vec3 positionAt(vec2 pixel, float depth)
{
    vec4 p = frame.pixelToEye * vec4(pixel, depth, 1.0);
    return p.xyz / p.w;
}

bool isAsked(ivec2 pixel, float depth)
{
    return depth > 0.0 && (kMapped || asksForOcclusion(texelFetch(surfaceTexture, pixel, 0)));
}

// The pixel that is looked at for a square of the picture: its first, or where nobody asks for that one the next that somebody asks for: a
// leaf may be thinner than the square.
ivec2 pixelOf(ivec2 first, ivec2 last)
{
    if (isAsked(first, depthAt(first))) return first;
    int divisor = int(frame.p.divisor);
    for (int k = 1; k < divisor * divisor; ++k) {
        ivec2 pixel = min(first + ivec2(k % divisor, k / divisor), last);
        if (isAsked(pixel, depthAt(pixel))) return pixel;
    }
    return first;
}

// False in the sky, which nothing hides, and where nobody asks: such a pixel says 1 and speaks of no surface.
bool seenPoint(out SeenPoint p)
{
    ivec2 last = frame.size - 1, first = min(ivec2(gl_FragCoord.xy) * int(frame.p.divisor), last);
    p.pixel = pixelOf(first, last);
    p.depth = depthAt(p.pixel);
    seen = vec4(1.0, 0.0, 0.0, 0.0);
    if (!isAsked(p.pixel, p.depth)) return false;
    uvec4 surface = texelFetch(surfaceTexture, p.pixel, 0);
    ivec2 x = ivec2(1, 0), y = ivec2(0, 1);
    p.slope.x = slopeOf(depthAt(max(p.pixel - x, ivec2(0))), p.depth, depthAt(min(p.pixel + x, last)), p.pixel.x == 0, p.pixel.x == last.x);
    p.slope.y = slopeOf(depthAt(max(p.pixel - y, ivec2(0))), p.depth, depthAt(min(p.pixel + y, last)), p.pixel.y == 0, p.pixel.y == last.y);
    p.position = positionAt(vec2(p.pixel), p.depth);
    p.toEye = frame.eye.w > 0.0 ? normalize(-p.position) : frame.eye.xyz;
    p.normal = octahedralDecode(unpackUnorm2x16(surface.x));
    vec3 across = positionAt(vec2(p.pixel + x), p.depth + p.slope.x) - p.position;
    vec3 down = positionAt(vec2(p.pixel + y), p.depth + p.slope.y) - p.position;
    bool flat_ = all(greaterThan(frame.size, ivec2(1))); // a picture of one row has no slope across it
    p.face = flat_ ? safeNormalize(cross(across, down), p.normal) : p.normal;
    if (dot(p.face, p.toEye) < 0.0) p.face = -p.face;
    if (dot(p.face, p.normal) < kOneSurface) p.face = p.normal; // the slope is that of the surface beside
    // What is said is said of the first pixel, where the surface would lie there
    seen.y = max(p.depth + dot(p.slope, vec2(first - p.pixel)), 1e-9);
    seen.zw = p.slope;
    return true;
}

// A surface in the depth buffer hides what it stands above: by its sine over the plane of the point, less than which is rounding.
const float kLeastSine = 0.02;

#endif
