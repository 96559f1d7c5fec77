#version 460
// A caster, seen from a light.
#include "engine/effects/shadow/shadow.h"
#include "shaders/bindings.glsl"

layout(push_constant, scalar) uniform Push { ShadowPush push; };

void main() { gl_Position = push.objectToClip * vec4(vertices[gl_VertexIndex].position, 1.0); }
