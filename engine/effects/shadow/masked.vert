#version 460
// A caster with an alpha mask, seen from a light.
#include "engine/effects/shadow/shadow.h"
#include "shaders/bindings.glsl"

layout(push_constant, scalar) uniform Push { ShadowPush push; };
layout(location = 0) out vec2 uv0;
layout(location = 1) out vec2 uv1;
layout(location = 2) out vec4 vertexColor;

void main()
{
    Vertex v = vertices[gl_VertexIndex];
    gl_Position = push.objectToClip * vec4(v.position, 1.0);
    uv0 = v.uv0;
    uv1 = v.uv1;
    vertexColor = unpackUnorm4x8(v.color);
}
