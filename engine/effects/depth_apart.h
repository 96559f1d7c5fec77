// How far two depths lie apart along the view.
#ifndef AFTERGLOW_DEPTH_APART_H
#define AFTERGLOW_DEPTH_APART_H
#include "shaders/glsl.h"
SHARED_BEGIN

// m. `metres`: what a step of depth is, x / depth^2 for a perspective, y for an orthographic eye; the other is 0.
FN float depthApart(float a, float b, vec2 metres) { return abs(a - b) * (metres.x > 0.0f ? metres.x / max(b * b, 1e-30f) : metres.y); }

SHARED_END
#endif
