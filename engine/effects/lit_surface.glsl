// The surfaces in the G-buffer for the passes that light them all: bindings 4 to 7 of set 1, after those of shading.glsl.
#ifndef AFTERGLOW_LIT_SURFACE_GLSL
#define AFTERGLOW_LIT_SURFACE_GLSL
#include "engine/effects/lit_layers.glsl"

layout(constant_id = kLightingEmission) const bool kEmission = false;
layout(constant_id = kLightingTraced) const bool kTraced = false;

layout(set = 1, binding = 4) uniform usampler2D surfaceTexture;
layout(set = 1, binding = 5) uniform sampler2D depthTexture;
layout(set = 1, binding = 6) uniform sampler2D emissionTexture;
layout(set = 1, binding = 7) uniform sampler2DArray tracedTexture; // share of the lights that reaches the surface, four a layer

float lightReaches(uint index, Light light, ShadedPoint p)
{
    if (kTraced) return texelFetch(tracedTexture, ivec3(gl_FragCoord.xy, index / 4u), 0)[index % 4u];
    return mapReaches(index, light, p);
}

vec3 emissionAt(ivec2 pixel) { return kEmission ? texelFetch(emissionTexture, pixel, 0).rgb : vec3(0.0); }

// The picture of a surface; where a mirror's image is added later, that has the other half of what a pixel holds.
vec4 sentBy(vec3 sum, uint mirrored)
{
    bool whole = mirrored == 0u;
    return vec4(min(sum, vec3(whole ? kHalfMax : 0.5 * kHalfMax)), whole ? 1.0 : 0.0);
}

#endif
