// How much of one pixel's visibility speaks for another: both lie on one plane.
#ifndef AFTERGLOW_PLANE_GLSL
#define AFTERGLOW_PLANE_GLSL
#include "engine/effects/occlusion/occlusion.h"

// `texel`: visibility, depth and slope of the pixel `at`; how far off its plane a depth `away` pixels from it lies.
float onPlane(vec4 texel, vec2 away, float depth, OcclusionFrame frame)
{
    const float kApart = 0.02; // of the range: visibility changes little over it
    float apart = depthApart(texel.y + dot(texel.zw, away), depth, frame.metres) / (kApart * frame.p.range);
    return 1.0 / ((1.0 + apart * apart) * (1.0 + apart * apart));
}

#endif
