// What rays meet, for passes that read the scene's set: what shaders/met.h asks for, and the level's triangles. How a ray is asked is
// another file's: shaders/trace.glsl by ray query, engine/effects/truth/programs.glsl by ray programs. Such a pass tells the constants of
// shaders/ray_scene.h (engine/effects/tracing.hpp does).
#ifndef AFTERGLOW_MET_GLSL
#define AFTERGLOW_MET_GLSL
#include "shaders/bindings.glsl"
#include "shaders/color.h"
#include "shaders/ray.h"
#include "shaders/ray_scene.h"
#include "shaders/texture_ref.h"

layout(constant_id = kTraceFiltered) const bool kFiltered = false;
layout(constant_id = kTraceTinted) const bool kTinted = false;
layout(constant_id = kTraceExact) const bool kExact = false;

// engine/upload/acceleration.cpp fills these.
layout(set = 0, binding = 17, scalar) readonly buffer RayTriangles { RayTriangle rayTriangles[]; };
layout(set = 0, binding = 18, scalar) readonly buffer RayInstances { Instance rayInstances[]; };
layout(set = 0, binding = 21, scalar) readonly buffer RayErrors { float rayErrors[]; }; // by material: GpuRays::meetingErrors

// Texel by texel, as the baker reads them. A device's filter may have weights of few bits, and decode sRGB by an approximation.
layout(set = 0, binding = 19, scalar) readonly buffer RayTexels { uint rayTexels[]; };
layout(set = 0, binding = 20, scalar) readonly buffer RayTextures { TexelRange rayTextures[]; };

struct TexelSource {
    uint unused;
};
vec4 texelAt(TexelSource all, TexelRange t, int x, int y)
{
    vec4 texel = unpackUnorm4x8(rayTexels[t.first + uint(y) * uint(t.size.x) + uint(x)]);
    return t.srgb != 0u ? vec4(srgbDecode(texel.rgb), texel.a) : texel;
}
#include "shaders/texel_filter.h"

// Level 0 always, as the baker reads them: a ray has no derivatives, and its truth filters by many samples.
struct TextureSet {
    uint unused;
};
vec4 texelOf(TextureSet all, TextureRef ref, vec2 uv0, vec2 uv1)
{
    if (ref.texture < 0) return vec4(1.0);
    if (kExact) return filteredTexel(TexelSource(0u), rayTextures[ref.texture], textureUv(ref, uv0, uv1));
    return textureLod(textures[nonuniformEXT(ref.texture)], textureUv(ref, uv0, uv1), 0.0);
}

#include "shaders/met.h"

const TextureSet kTextures = TextureSet(0u);

Material materialOf(uint triangle) { return materials[rayInstances[rayTriangles[triangle].instance].material]; }

MetPoint metPoint(uint triangle, vec2 barycentric)
{
    RayTriangle t = rayTriangles[triangle];
    Instance instance = rayInstances[t.instance];
    return metPoint(placedVertex(instance, vertices[t.vertex[0]]), placedVertex(instance, vertices[t.vertex[1]]),
                    placedVertex(instance, vertices[t.vertex[2]]), barycentric);
}

// What of a shadow ray passes the candidate: all of it through a hole of a mask, the share that a blended surface lets by, the tint of
// clear thin glass. The baker draws lots for the blended share instead, with the same mean.
vec3 passesOn(uint triangle, vec2 barycentric, vec3 direction)
{
    Material m = materialOf(triangle);
    MetPoint p = metPoint(triangle, barycentric);
    vec4 color = metColor(kTextures, m, p);
    float share = metShare(m, color.a);
    vec3 tint = vec3(0.0);
    if (kTinted && share > 0.0) tint = metTint(kTextures, m, p, color, direction);
    return vec3(1.0 - share) + share * tint;
}

bool isMet(uint triangle, vec2 barycentric, vec3 direction)
{
    Material m = materialOf(triangle);
    return metDraw(triangle, barycentric, direction) < metShare(m, metColor(kTextures, m, metPoint(triangle, barycentric)).a);
}

// The shading point of a hit; ray.direction says from where it is seen.
Surface surfaceAt(Ray ray, Hit hit)
{
    return metSurface(kTextures, materialOf(hit.triangle), metPoint(hit.triangle, hit.barycentric), ray.direction);
}

#endif
