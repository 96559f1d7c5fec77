#version 460
// What a surface is, before any light: its G-buffer texel, and what it emits by itself.
#include "engine/effects/geometry/geometry.h"
#include "engine/effects/surface_push.h"
#include "shaders/material.glsl"

layout(constant_id = kGeometryMasked) const bool kMasked = false;
layout(constant_id = kGeometryEmission) const bool kEmission = false;
layout(constant_id = kGeometryObjects) const bool kObjects = false;

layout(push_constant, scalar) uniform Push { SurfacePush push; };
layout(location = 0) in vec3 worldNormal;
layout(location = 1) in vec4 worldTangent;
layout(location = 2) in vec2 uv0;
layout(location = 3) in vec2 uv1;
layout(location = 4) in vec4 vertexColor;
layout(location = 0) out uvec4 surface;
layout(location = 1) out vec4 emission;
layout(location = 2) out uint object;

void main()
{
    MaterialTexel m = sampleMaterial(push.material, uv0, uv1, vertexColor);
    if (kMasked && isCutOut(m.alpha, materials[push.material].alphaCutoff)) discard;

    GBufferTexel t;
    t.normal = shadingNormal(push.material, worldNormal, worldTangent, uv0, uv1);
    t.baseColor = m.baseColor;
    t.roughness = m.roughness;
    t.metallic = m.metallic;
    t.lightmapUv = uv1 * push.lightmapScale + push.lightmapOffset;
    t.material = push.material;
    t.page = pageSeen(pushedPage(push.page));
    t.mirrored = pushedMirrored(push.page);
    surface = encodeGBuffer(t);
    if (kEmission) emission = vec4(m.emission, 1.0);
    if (kObjects) object = push.object + 1u;
}
