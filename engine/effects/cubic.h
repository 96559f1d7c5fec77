// The cubic through evenly spaced samples (Catmull & Rom 1974): sharper than a linear blend, exact on quadratics, overshooting at edges.
#ifndef AFTERGLOW_CUBIC_H
#define AFTERGLOW_CUBIC_H
#include "shaders/glsl.h"
SHARED_BEGIN

// Weights of four samples at `t`, 0..1, between the second and the third.
FN vec4 cubicWeights(float t)
{
    return vec4(t * (-0.5f + t * (1.0f - 0.5f * t)), 1.0f + t * t * (-2.5f + 1.5f * t), t * (0.5f + t * (2.0f - 1.5f * t)),
                t * t * (-0.5f + 0.5f * t));
}

SHARED_END
#endif
