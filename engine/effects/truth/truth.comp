#version 460
// Path tracing in one kernel: whole paths, their rays asked by ray query.
#include "engine/effects/truth/truth.h"
#include "shaders/trace.glsl"
#include "engine/effects/truth/pixel.glsl"

layout(local_size_x = kTruthGroup, local_size_y = kTruthGroup) in;

void main()
{
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (all(lessThan(pixel, frame.picture.size))) samplePixel(pixel);
}
