#version 460
// Visibility at every pixel, from those of its neighbours of the lower resolution that lie on its surface.
#include "engine/effects/occlusion/plane.glsl"

layout(constant_id = kOcclusionMapped) const bool kMapped = true;

layout(set = 1, binding = 0, scalar) uniform Occlusion { OcclusionFrame frame; };
layout(set = 1, binding = 1) uniform usampler2D surfaceTexture;
layout(set = 1, binding = 2) uniform sampler2D depthTexture;
layout(set = 1, binding = 3) uniform sampler2D seenTexture;

layout(location = 0) in vec2 uv;
layout(location = 0) out float visibility;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    visibility = 1.0;
    if (!kMapped && !asksForOcclusion(texelFetch(surfaceTexture, pixel, 0))) return;
    float depth = texelFetch(depthTexture, pixel, 0).r;
    if (!(depth > 0.0)) return;
    int divisor = int(frame.p.divisor);
    ivec2 corner = pixel / divisor, last = textureSize(seenTexture, 0) - 1;
    if (divisor == 1) {
        visibility = texelFetch(seenTexture, corner, 0).x;
        return;
    }
    ivec2 off = pixel - corner * divisor;
    vec2 sum = vec2(0.0);
    for (int k = 0; k < 4; ++k) {
        ivec2 step_ = ivec2(k & 1, k >> 1);
        vec2 share = mix(1.0 - vec2(off) / float(divisor), vec2(off) / float(divisor), vec2(step_));
        ivec2 at = min(corner + step_, last);
        vec4 texel = texelFetch(seenTexture, at, 0);
        if (!(texel.y > 0.0) || share.x * share.y == 0.0) continue;
        float weight = share.x * share.y * onPlane(texel, vec2(pixel - min(at * divisor, frame.size - 1)), depth, frame);
        sum += weight * vec2(texel.x, 1.0);
    }
    if (sum.y > 0.0) visibility = sum.x / sum.y;
}
