#version 460
// One vertex of a surface, pulled from the scene's buffer, to clip space.
#include "engine/effects/surface_push.h"
#include "shaders/bindings.glsl"

layout(push_constant, scalar) uniform Push { SurfacePush push; };
invariant gl_Position; // passes that draw a surface again meet its depth
layout(location = 0) out vec3 worldNormal;
layout(location = 1) out vec4 worldTangent;
layout(location = 2) out vec2 uv0;
layout(location = 3) out vec2 uv1;
layout(location = 4) out vec4 vertexColor;

void main()
{
    Vertex v = vertices[gl_VertexIndex];
    gl_Position = push.objectToClip * vec4(v.position, 1.0);
    worldNormal = cofactors(push.objectToWorld) * v.normal;
    worldTangent = vec4(push.objectToWorld * v.tangent.xyz, v.tangent.w);
    uv0 = v.uv0;
    uv1 = v.uv1;
    vertexColor = unpackUnorm4x8(v.color);
}
