// What compositing wants to know of the surfaces: decoded from the G-buffer by layers.frag.
#ifndef AFTERGLOW_LAYERS_H
#define AFTERGLOW_LAYERS_H
#include "shaders/constants.h"
SHARED_BEGIN

struct LayersFrame {
    mat4 clipToWorld;
    mat4 toLast; // from clip space to the last frame's; exactly 1 while the eye rests
    vec4 eye;    // w = 1: position; 0: the direction towards an orthographic eye
};

// Specialization constant: some object moved.
const uint kLayersMoved = 0u;

// Depth of what is infinitely far, m: what Blender writes there.
const float kLayerSky = 1e10f;

SHARED_END
#endif
