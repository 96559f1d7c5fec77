#version 460
// The nearest of all that is met.
#extension GL_EXT_ray_tracing : require
#include "engine/effects/truth/hit.glsl"
#include "shaders/ray.h"

layout(location = 0) rayPayloadInEXT Hit hit;

void main() { hit = Hit(gl_HitTEXT, triangleMet(), barycentric); }
