#version 460
// Nothing is met.
#extension GL_EXT_ray_tracing : require
#include "shaders/ray.h"

layout(location = 0) rayPayloadInEXT Hit hit;

void main() { hit = Hit(kRayFar, 0u, vec2(0.0)); }
