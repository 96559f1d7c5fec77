#version 460
// One level of the pyramid of depths: the nearest and the farthest of four squares. The first level copies the depth buffer; its size is
// rounded up so that every level halves evenly, and what lies beyond the picture repeats its border.
#include "engine/effects/reflection/reflection.h"

layout(constant_id = kReflectionFirst) const bool kFirst = false;

layout(set = 1, binding = 0) uniform sampler2D finer;
layout(location = 0) out vec2 range; // reversed depths: nearest (greatest), farthest

void main()
{
    ivec2 at = ivec2(gl_FragCoord.xy);
    if (kFirst) {
        range = vec2(texelFetch(finer, min(at, textureSize(finer, 0) - 1), 0).r);
        return;
    }
    vec2 a = texelFetch(finer, 2 * at, 0).rg, b = texelFetch(finer, 2 * at + ivec2(1, 0), 0).rg;
    vec2 c = texelFetch(finer, 2 * at + ivec2(0, 1), 0).rg, d = texelFetch(finer, 2 * at + ivec2(1, 1), 0).rg;
    range = vec2(max(max(a.x, b.x), max(c.x, d.x)), min(min(a.y, b.y), min(c.y, d.y)));
}
