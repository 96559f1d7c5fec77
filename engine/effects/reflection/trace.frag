#version 460
// Where the mirrored ray of every second pixel meets a surface that the picture shows: how far away, and how sure that is.
#include "engine/effects/reflection/mirror.glsl"
#include "engine/effects/view_ray.h"

layout(set = 1, binding = 0, scalar) uniform Reflection { ReflectionFrame reflection; };
layout(set = 1, binding = 1) uniform usampler2D surfaceTexture;
layout(set = 1, binding = 2) uniform sampler2D depths; // the pyramid
layout(set = 1, binding = 3) uniform sampler2D radianceTexture;

layout(location = 0) out uvec4 traced; // m to what is met, how sure that is, the pixel's own depth (all as bits), and its normal
layout(location = 1) out vec4 seen;    // its colour, times the share, which is a
layout(location = 2) out float near;   // 1/m to it, times the share

struct DepthPyramid {
    ivec2 last; // pixel of the picture
};
vec2 depthRange(DepthPyramid pyramid, int level, ivec2 cell) { return texelFetch(depths, clamp(cell, ivec2(0), pyramid.last >> level), level).rg; }
float depthBetween(DepthPyramid pyramid, vec2 at)
{
    vec2 corner = floor(at - 0.5), f = at - 0.5 - corner;
    ivec2 a = clamp(ivec2(corner), ivec2(0), pyramid.last), b = clamp(ivec2(corner) + 1, ivec2(0), pyramid.last);
    float top = mix(texelFetch(depths, a, 0).r, texelFetch(depths, ivec2(b.x, a.y), 0).r, f.x);
    return mix(top, mix(texelFetch(depths, ivec2(a.x, b.y), 0).r, texelFetch(depths, b, 0).r, f.x), f.y);
}
#include "engine/effects/reflection/march.h"

void main()
{
    traced = uvec4(0u);
    seen = vec4(0.0);
    near = 0.0;
    ivec2 pixel = ivec2(gl_FragCoord.xy) * int(reflection.divisor);
    if (pixel != min(pixel, reflection.size - 1)) return; // the textures are rounded up
    float depth = texelFetch(depths, pixel, 0).r;
    uvec4 surface = texelFetch(surfaceTexture, pixel, 0);
    traced = uvec4(0u, 0u, floatBitsToUint(depth), surface.x);
    if (!(depth > 0.0)) return;
    GBufferTexel t = decodeGBuffer(surface);
    if (!mirrors(t)) return;

    vec2 size = vec2(reflection.size);
    vec3 position = worldFromDepth((vec2(pixel) + 0.5) / size, depth, reflection.clipToWorld);
    vec3 toEye = directionToEye(position, reflection.eye);
    vec3 direction = mirrorDirection(toEye, visibleNormal(t.normal, t.normal, toEye));

    March how;
    how.steps = reflection.steps;
    how.bisections = reflection.bisections;
    how.levels = kReflectionDepthLevels;
    how.thickness = Thickness(reflection.thicknessShare, reflection.thicknessDepths);
    ScreenRay ray = makeScreenRay(reflection.worldToClip, position, direction, size);
    MarchHit hit = march(DepthPyramid(reflection.size - 1), ray, how);
    if (!(hit.along < 1.0)) return;

    vec3 met = alongRay(ray, hit.along);
    vec3 there = octahedralDecode(unpackUnorm2x16(texelFetch(surfaceTexture, clamp(ivec2(met.xy), ivec2(0), reflection.size - 1), 0).x));
    float share = hiddenShare(hit.behind) * facingShare(-dot(there, direction));
    vec4 radiance = textureLod(radianceTexture, met.xy / size, 0.0);
    float distance_ = length(worldFromDepth(met.xy / size, met.z, reflection.clipToWorld) - position);
    traced.x = floatBitsToUint(distance_);
    traced.y = floatBitsToUint(share);
    share *= radiance.a * borderShare(met.xy / size);
    seen = share * vec4(radiance.rgb, 1.0);
    near = share * min(1.0 / max(distance_, 1e-9), kHalfMax);
}
