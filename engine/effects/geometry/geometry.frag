#version 460
// What a surface is, before any light: its G-buffer texel, and what it emits by itself.
#include "engine/effects/geometry/geometry.h"
#include "engine/effects/surface_push.h"
#include "shaders/material.glsl"

layout(constant_id = kGeometryMasked) const bool kMasked = false;
layout(constant_id = kGeometryEmission) const bool kEmission = false;
layout(constant_id = kGeometryObjects) const bool kObjects = false;
layout(constant_id = kGeometryFacets) const bool kFacets = false;

layout(push_constant, scalar) uniform Push { SurfacePush push; };
layout(location = 0) in vec3 worldNormal;
layout(location = 1) in vec4 worldTangent;
layout(location = 2) in vec2 uv0;
layout(location = 3) in vec2 uv1;
layout(location = 4) in vec4 vertexColor;
layout(location = 0) out uvec4 surface;
layout(location = 1) out vec4 emission;
layout(location = 2) out uint object;
layout(location = 3) out float facets;

// A pixel that holds many normals mirrors as a rougher surface would: twice the variance of the interpolated one over the pixel widens
// alpha^2, up to a bound.
// This work is based on: Tokuyoshi, Kaplanyan 2019, "Improved geometric specular antialiasing".
float widened(float roughness, vec3 normal)
{
    const float kPixelVariance = 0.25, kMostWidened = 0.18; // px^2 of the pixel's filter; both theirs
    vec3 across = dFdx(normal), down = dFdy(normal);
    float alpha = roughness * roughness, kernel = min(2.0 * kPixelVariance * (dot(across, across) + dot(down, down)), kMostWidened);
    return min(sqrt(sqrt(alpha * alpha + kernel)), 1.0);
}

void main()
{
    MaterialTexel m = sampleMaterial(push.material, uv0, uv1, vertexColor);
    if (kMasked && isCutOut(m.alpha, materials[push.material].alphaCutoff)) discard;

    GBufferTexel t;
    t.normal = shadingNormal(push.material, worldNormal, worldTangent, uv0, uv1);
    t.baseColor = m.baseColor;
    t.roughness = widened(m.roughness, safeNormalize(worldNormal, vec3(0.0)));
    t.metallic = m.metallic;
    t.lightmapUv = uv1 * push.lightmapScale + push.lightmapOffset;
    t.material = push.material;
    t.page = pageSeen(pushedPage(push.page));
    t.mirrored = pushedMirrored(push.page);
    surface = encodeGBuffer(t);
    if (kEmission) emission = vec4(m.emission, 1.0);
    if (kObjects) object = push.object + 1u;
    if (kFacets) facets = m.roughness;
}
