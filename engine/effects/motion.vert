#version 460
// A surface that moved: where it is, and where it was.
#include "engine/effects/motion.h"
#include "shaders/bindings.glsl"

layout(push_constant, scalar) uniform Push { MotionPush push; };
layout(location = 0) out vec4 last;

void main()
{
    vec4 position = vec4(vertices[gl_VertexIndex].position, 1.0);
    gl_Position = push.objectToClip * position;
    last = push.objectToLast * position;
}
