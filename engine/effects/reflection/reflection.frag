#version 460
// Over the lit picture: in place of what the interfaces mirrored of the probes, what they mirror of the picture, as far as it is known, or
// of the level.
// Each pixel mirrors in its own direction, at the distance that the traced rays around it agree on.
#include "engine/effects/interfaces.glsl"
#include "engine/effects/reflection/reflection.h"
#include "engine/effects/view_ray.h"
#include "shaders/gbuffer.h"
#include "shaders/surface.h"

layout(constant_id = kReflectionCubemaps) const bool kCubemaps = false;
layout(constant_id = kReflectionLayer) const bool kLayer = false;
layout(constant_id = kReflectionRays) const bool kRays = false;
layout(constant_id = kReflectionFacets) const bool kFacets = false;

layout(set = 1, binding = 0, scalar) uniform Reflection { ReflectionFrame reflection; };
layout(set = 1, binding = 1) uniform usampler2D surfaceTexture;
layout(set = 1, binding = 2) uniform sampler2D depthTexture;
layout(set = 1, binding = 3) uniform sampler2D radianceTexture;
layout(set = 1, binding = 4) uniform sampler2D mirroredTexture;
layout(set = 1, binding = 5) uniform usampler2D tracedTexture;
layout(set = 1, binding = 6) uniform sampler2D seenTexture; // the pyramids of what was met
layout(set = 1, binding = 7) uniform sampler2D nearTexture;
layout(set = 1, binding = 8) uniform sampler2D facetTexture;

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 radiance;
layout(location = 1) out vec4 layer; // kLayer: the part of it that is mirrored

#include "engine/effects/reflection/neighbours.glsl"

// Premultiplied by what is known. A sharp image: what the picture shows where this pixel's own ray ends, or what the ray met itself.
vec4 sharpLight(vec3 position, vec3 direction, Met met)
{
    if (kRays) return texelFetch(seenTexture, ivec2(gl_FragCoord.xy), 0);
    vec4 clip = reflection.worldToClip * vec4(position + direction * met.distance_, 1.0);
    if (!(met.sharp > 0.0 && clip.w > 0.0)) return vec4(0.0);
    vec2 at = clamp(ndcToUv(clip.xy / clip.w), 0.0, 1.0);
    vec4 light = textureLod(radianceTexture, at, 0.0);
    return met.sharp * light.a * borderShare(at) * vec4(light.rgb, 1.0);
}

// From the picture to the textures of traced rays, which are rounded up; ray i stands at the centre of pixel i * divisor.
vec2 amongRays(vec2 at)
{
    float divisor = float(reflection.divisor);
    return (at * vec2(reflection.size) / divisor + (0.5 - 0.5 / divisor)) / vec2(textureSize(seenTexture, 0));
}

// Where the picture shows the image of what lies at that distance along a ray, which leaves the mirrored one by `aside` for each metre.
vec2 placeOfTap(vec3 position, vec3 toEye, vec3 aside, float distance_)
{
    vec4 clip = reflection.worldToClip * vec4(position + (aside - toEye) * distance_, 1.0);
    return ndcToUv(clip.xy / max(clip.w, 1e-9));
}

// Premultiplied too. A blurred one: the mirrored world lies behind the surface, straight on from the eye, and what the rays around met is its
// image. A lobe is long in the plane of incidence: a row of taps, each as wide as the lobe is across.
vec4 blurredLight(vec3 position, vec3 normal, vec3 toEye, float alpha, float distance_, float level)
{
    const float kNearer = 1.25; // times
    vec3 up = safeNormalize(normal - toEye * dot(normal, toEye), vec3(0.0)); // across the view, in the plane of incidence
    vec4 sum = vec4(0.0);
    float weights = 0.0;
    for (int k = 0; k < 4; ++k) {
        float slope = alpha * lobeSlope(k);
        float weight = max(dot(toEye, normal) - slope * dot(normal, up), 0.0); // of facets, by how much of them the eye sees
        vec2 at = placeOfTap(position, toEye, up * (2.0 * slope), distance_);
        bool within = at == clamp(at, 0.0, 1.0);
        if (within || !kRays) weights += weight; // by rays, what the picture cuts off of the lobe is as what is left
        if (!within) continue;
        float wide = level + lobeWidening(k);
        vec4 there = textureLod(seenTexture, amongRays(at), wide);
        float nearness = textureLod(nearTexture, amongRays(at), wide).r;
        if (nearness * distance_ > kNearer * there.a) { // what is nearer has its image elsewhere, and narrower: is it in the lobe there?
            at = placeOfTap(position, toEye, up * (2.0 * slope), there.a / nearness);
            there = at == clamp(at, 0.0, 1.0) ? textureLod(seenTexture, amongRays(at), max(wide - 1.0, 0.0)) : vec4(0.0);
        }
        sum += weight * there;
    }
    return weights > 0.0 ? sum / weights : vec4(0.0);
}

// Where the pixel's own rays met nothing, the lobe may still: its distance is then that of what was met around, near before far.
float lobeDistance(Met met)
{
    const float kNear = 3.0, kFar = float(kReflectionBlurLevels - 1); // levels: squares of 8 and of 32 rays
    const float kFarShare = 0.01;
    vec2 at = amongRays(uv);
    float share = met.share, sum = met.share / max(met.distance_, 1e-9);
    share += textureLod(seenTexture, at, kNear).a + kFarShare * textureLod(seenTexture, at, kFar).a;
    sum += textureLod(nearTexture, at, kNear).r + kFarShare * textureLod(nearTexture, at, kFar).r;
    return share > 0.0 ? share / max(sum, share * kLeastNearness) : 0.0;
}

vec4 mirroredLight(vec3 position, vec3 normal, vec3 toEye, float alpha, Met met)
{
    float distance_ = lobeDistance(met);
    float w = max((reflection.worldToClip * vec4(position - toEye * distance_, 1.0)).w, 1e-9);
    // How far apart the rays of two pixels end: by how they leave the eye, and by how the surface bends them
    float apart = w / reflection.pixelsPerMetre + 2.0 * met.bend * distance_;
    float length_ = distance_ * lobeTangent(alpha) / apart, width = length_ * max(dot(normal, toEye), kNarrowest) * kTapWidth; // px
    vec4 sharp = length_ < 2.0 ? sharpLight(position, mirrorDirection(toEye, normal), met) : vec4(0.0);
    if (!(length_ > 1.0)) return sharp;
    float level = max(log2(max(width, 1e-3) / float(reflection.divisor)), 0.0);
    return mix(sharp, blurredLight(position, normal, toEye, alpha, distance_, level), min(length_ - 1.0, 1.0));
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    radiance = texelFetch(radianceTexture, pixel, 0);
    if (kLayer) layer = texelFetch(mirroredTexture, pixel, 0);
    GBufferTexel t = decodeGBuffer(texelFetch(surfaceTexture, pixel, 0));
    float share = t.mirrored == 0u ? reflectionShare(t.roughness) : 0.0; // else an eye behind the mirror sees it
    if (!(share > 0.0)) return; // before anything else is fetched: most pixels end here
    vec4 mirrored = texelFetch(mirroredTexture, pixel, 0);
    float depth = texelFetch(depthTexture, pixel, 0).r;
    if (!(depth > 0.0) || mirrored.a == 0.0) return;
    Bsdf b = seenBsdf(t, kFacets ? texelFetch(facetTexture, pixel, 0).r : 0.0);
    if (!hasInterface(b)) return;

    vec3 position = worldFromDepth(uv, depth, reflection.clipToWorld);
    vec3 toEye = directionToEye(position, reflection.eye);
    vec3 normal = visibleNormal(t.normal, t.normal, toEye);
    Met met = metAround(pixel, depth, t.normal, position, mirrorDirection(toEye, normal));
    vec4 light = mirroredLight(position, normal, toEye, b.alpha.x, met);
    if (!(light.a > 0.0)) return;
    share *= light.a; // beyond the mirror's rim nothing is known: a narrow frame's few rays are not its whole lobe

    float cosEye = localEye(makeFrame(t.normal), toEye).z;
    vec3 sent = light.rgb / light.a * interfaceShare(b, cosEye, kCubemaps);
    vec3 change = share * (sent - mirrored.rgb);
    radiance.rgb = clamp(radiance.rgb + change, vec3(0.0), vec3(kHalfMax));
    if (kLayer) layer.rgb = clamp(layer.rgb + change, vec3(0.0), vec3(kHalfMax));
}
