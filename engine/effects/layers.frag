#version 460
// The surfaces under the pixels, as compositing wants them: normal and depth, object and material, motion.
#include "engine/effects/layers.h"
#include "engine/effects/motion.h"
#include "engine/effects/view_ray.h"
#include "shaders/gbuffer.h"

layout(constant_id = kLayersMoved) const bool kMoved = false;

layout(set = 1, binding = 0, scalar) uniform Layers { LayersFrame frame; };
layout(set = 1, binding = 1) uniform usampler2D surfaceTexture;
layout(set = 1, binding = 2) uniform sampler2D depthTexture;
layout(set = 1, binding = 3) uniform usampler2D objectTexture;
layout(set = 1, binding = 4) uniform sampler2D motionTexture;

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 surface; // xyz the normal in the world, w the depth along the view axis, m
layout(location = 1) out vec2 ids;     // of object and material
layout(location = 2) out vec4 motion;  // px, right and up, as Blender's pass `Vector`: xy then - now, zw now - next

// The next frame is not known: what moves is taken to go on as it came. What was behind the eye came from nowhere.
vec4 motionOf(vec4 clip, ivec2 pixel)
{
    vec4 now = placeThen(clip), then = placeThen(frame.toLast * clip); // alike, so that what rests does so exactly
    if (kMoved) {
        vec4 moved = texelFetch(motionTexture, pixel, 0);
        if (moved.a > 0.0) then = moved;
    }
    if (then.a == kMotionBehind) return vec4(0.0);
    return ((then.xy - now.xy) * vec2(textureSize(depthTexture, 0)) * vec2(1.0, -1.0)).xyxy;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depthTexture, pixel, 0).r;
    motion = motionOf(vec4(uvToNdc(uv), depth, 1.0), pixel);
    surface = vec4(vec3(0.0), kLayerSky);
    ids = vec2(0.0);
    if (!(depth > 0.0)) return;
    GBufferTexel t = decodeGBuffer(texelFetch(surfaceTexture, pixel, 0));
    ViewRay ray = viewRay(uv, depth, frame.clipToWorld, frame.eye);
    vec3 axis = viewRay(vec2(0.5), 0.0, frame.clipToWorld, frame.eye).direction;
    surface = vec4(t.normal, ray.distance * dot(ray.direction, axis));
    ids = vec2(float(texelFetch(objectTexture, pixel, 0).r), float(t.material + 1u));
}
