#version 460
// A surface that light passes: alpha blended or transmissive. Drawn over the lit picture, far to near, premultiplied: rgb is what it sends
// to the eye, alpha how much it hides of what lies behind, which is seen straight through.
#include "engine/effects/lit_layers.glsl"
#include "engine/effects/surface_push.h"
#include "shaders/camera.h"
#include "shaders/material.glsl"

layout(push_constant, scalar) uniform Push { SurfacePush push; };
layout(location = 0) in vec3 worldNormal;
layout(location = 1) in vec4 worldTangent;
layout(location = 2) in vec2 uv0;
layout(location = 3) in vec2 uv1;
layout(location = 4) in vec4 vertexColor;
layout(location = 0) out vec4 radiance;

float lightReaches(uint index, Light light, ShadedPoint p) { return mapReaches(index, light, p); }

void main()
{
    MaterialTexel m = sampleMaterial(push.material, uv0, uv1, vertexColor);
    Material material = materials[push.material];
    float coverage = (material.flags & kMaterialAlphaBlend) != 0u ? clamp(m.alpha, 0.0, 1.0) : 1.0;

    ShadedPoint p;
    p.position = worldFromDepth(gl_FragCoord.xy / lighting.size, gl_FragCoord.z, lighting.clipToWorld);
    p.normal = shadingNormal(push.material, worldNormal, worldTangent, uv0, uv1);
    p.bent = hasNormalMap(push.material);
    p.toEye = directionToEye(p.position, lighting.eye);
    vec3 across = dFdx(p.position), down = dFdy(p.position);
    p.face = faceNormal(across, down, p.normal, p.toEye);
    p.off = cornerRounding(p.position, gl_FragCoord.xy / lighting.size, 1.0 / lighting.size, gl_FragCoord.z, lighting.clipToWorld);
    p.roughness = m.roughness;
    p.lightmapUv = uv1 * push.lightmapScale + push.lightmapOffset;
    p.page = pageSeen(pushedPage(push.page));
    p.mirrored = pushedMirrored(push.page);
    p.open = 1.0; // visibility is known of what lies behind

    Frame frame = makeFrame(p.normal);
    vec3 wo = localEye(frame, p.toEye);
    Bsdf b = roundBsdf(material, vec4(m.baseColor, 1.0), vec2(m.roughness, m.metallic), m.transmission, gl_FrontFacing);
    LeavingLight light = leavingLight(b, frame, wo, p);
    float passed = meanOf(b.transmission) * layerPass(b, wo.z);
    float alpha = coverage * (1.0 - passed);
    radiance = vec4(min(sumOf(light) + m.emission, vec3(kHalfMax)) * coverage, alpha);
    writeLayers(light, m.emission, coverage, alpha);
}
