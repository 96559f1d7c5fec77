#version 460
// Where the mask lets light through there is no caster.
#include "engine/effects/shadow/shadow.h"
#include "shaders/material.glsl"

layout(push_constant, scalar) uniform Push { ShadowPush push; };
layout(location = 0) in vec2 uv0;
layout(location = 1) in vec2 uv1;
layout(location = 2) in vec4 vertexColor;
layout(depth_less) out float gl_FragDepth;

void main()
{
    float rise = fwidth(gl_FragCoord.z); // before the neighbours are gone
    if (isCutOut(sampleMaterial(push.material, uv0, uv1, vertexColor).alpha, materials[push.material].alphaCutoff)) discard;
    gl_FragDepth = pushedBack(gl_FragCoord.z, rise, push.furthest);
}
