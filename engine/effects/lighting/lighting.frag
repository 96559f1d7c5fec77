#version 460
// Radiance toward the eye from what the G-buffer holds; the sky where it holds nothing.
#include "engine/effects/lighting/lighting.h"
#include "engine/effects/lit_surface.glsl"
#include "engine/effects/view_ray.h"
#include "shaders/sky.glsl"

layout(constant_id = kLightingSkyImage) const bool kSkyImage = false;
layout(constant_id = kLightingFacets) const bool kFacets = false;

layout(set = 1, binding = 8) uniform sampler2D visibilityTexture;
layout(set = 1, binding = 9) uniform sampler2D facetTexture;

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 radiance;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depthTexture, pixel, 0).r;
    vec3 position = worldFromDepth(uv, depth > 0.0 ? depth : 1.0, lighting.clipToWorld); // the sky has none: any that is finite
    vec3 across = dFdx(position), down = dFdy(position); // here, where the sky's pixels still are neighbours
    vec2 step_ = vec2(dFdx(uv.x), dFdy(uv.y));
    if (!(depth > 0.0)) {
        ViewRay ray = viewRay(uv, depth, lighting.clipToWorld, lighting.eye);
        vec3 sky = skyRadianceFrom(ray.direction, lighting.skyRadiance, lighting.skyRotation, kSkyImage);
        radiance = vec4(sky, 0.0);
        writeLayers(LeavingLight(vec3(0.0), vec3(0.0), vec3(0.0)), sky, 1.0, 0.0);
        return;
    }
    GBufferTexel t = decodeGBuffer(texelFetch(surfaceTexture, pixel, 0));
    ShadedPoint p;
    p.position = position;
    p.normal = t.normal;
    p.bent = hasNormalMap(t.material);
    p.toEye = directionToEye(p.position, lighting.eye);
    p.face = faceNormal(across, down, p.normal, p.toEye);
    p.off = cornerRounding(p.position, uv, step_, depth, lighting.clipToWorld);
    p.roughness = t.roughness;
    p.lightmapUv = t.lightmapUv;
    p.page = t.page;
    p.open = kOcclusion && !hasLightmap(t.page) ? texelFetch(visibilityTexture, pixel, 0).r : 1.0; // a lightmap holds it already
    p.mirrored = t.mirrored;

    Frame frame = makeFrame(t.normal);
    vec3 wo = localEye(frame, p.toEye);
    Bsdf b = seenBsdf(t, kFacets ? texelFetch(facetTexture, pixel, 0).r : 0.0);
    LeavingLight light = leavingLight(b, frame, wo, p);
    vec3 emission = emissionAt(pixel);
    radiance = sentBy(sumOf(light) + emission, t.mirrored);
    writeLayers(light, emission, 1.0, 1.0);
}
