#version 460
// The surfaces under the pixels, as compositing wants them: normal and depth, object and material.
#include "engine/effects/layers.h"
#include "engine/effects/view_ray.h"
#include "shaders/gbuffer.h"

layout(set = 1, binding = 0, scalar) uniform Layers { LayersFrame frame; };
layout(set = 1, binding = 1) uniform usampler2D surfaceTexture;
layout(set = 1, binding = 2) uniform sampler2D depthTexture;
layout(set = 1, binding = 3) uniform usampler2D objectTexture;

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 surface; // xyz the normal in the world, w the depth along the view axis, m
layout(location = 1) out vec2 ids; // of object and material

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depthTexture, pixel, 0).r;
    if (!(depth > 0.0)) {
        surface = vec4(vec3(0.0), kLayerSky);
        ids = vec2(0.0);
        return;
    }
    GBufferTexel t = decodeGBuffer(texelFetch(surfaceTexture, pixel, 0));
    ViewRay ray = viewRay(uv, depth, frame.clipToWorld, frame.eye);
    vec3 axis = viewRay(vec2(0.5), 0.0, frame.clipToWorld, frame.eye).direction;
    surface = vec4(t.normal, ray.distance * dot(ray.direction, axis));
    ids = vec2(float(texelFetch(objectTexture, pixel, 0).r), float(t.material + 1u));
}
