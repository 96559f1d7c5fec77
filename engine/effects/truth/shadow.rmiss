#version 460
// Nothing ended the shadow ray.
#extension GL_EXT_ray_tracing : require
#include "engine/effects/truth/payload.glsl"

layout(location = 1) rayPayloadInEXT Passed passed;

void main() { passed.arrived = 1u; }
