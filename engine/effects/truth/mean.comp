#version 460
// The wavefront is over: the mean of all samples.
#include "engine/effects/truth/truth.h"

layout(local_size_x = kTruthGroup, local_size_y = kTruthGroup) in;
layout(push_constant, scalar) uniform Push { TruthPush push; };
layout(set = 1, binding = 0, rgba32f) readonly uniform image2D sum;
layout(set = 1, binding = 1, rgba32f) writeonly uniform image2D mean;

void main()
{
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(mean)))) return;
    imageStore(mean, pixel, vec4(imageLoad(sum, pixel).rgb / float(push.first + push.count), 1.0));
}
