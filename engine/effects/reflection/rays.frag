#version 460
// What the mirrored ray of every pixel meets in the level, lit as the picture is, and how far away it is: the twin of trace.frag.
#include "engine/effects/reflection/mirror.glsl"
#include "engine/effects/shading.glsl"
#include "engine/effects/slope.glsl"
#include "shaders/color.h"
#include "shaders/light_ray.h"
#include "shaders/sky.glsl"
#include "shaders/trace.glsl"

layout(constant_id = kReflectionSkyImage) const bool kSkyImage = false;
layout(constant_id = kLightingTraced) const bool kTraced = false;

layout(set = 1, binding = 4, scalar) uniform Reflection { ReflectionFrame reflection; };
layout(set = 1, binding = 5) uniform usampler2D surfaceTexture;
layout(set = 1, binding = 6) uniform sampler2D depthTexture;

layout(location = 0) out uvec4 traced; // m to what is met, 1, the pixel's own depth (all as bits), and its normal
layout(location = 1) out vec4 seen;    // its colour; a = 1 where there is a ray
layout(location = 2) out float near;   // 1/m to it, 0: the sky

// Shadows by the means of the picture's own. A ray to the light's centre: what is mirrored is small or blurred.
float lightReaches(uint index, Light light, ShadedPoint p)
{
    if (!kTraced) return mapReaches(index, light, p);
    LightSample s = sampleLight(light, p.position, vec2(0.5));
    if (!(dot(s.direction, p.face) > 0.0)) return 0.0;
    Ray ray = rayToLight(p.position, leaving(p.position, p.off, p.face), s);
    return ray.far > 0.0 ? luminance(transmittance(ray)) : 1.0;
}

// What a surface sends back along the ray, the share of what lies behind it that comes through, and where the ray goes on.
struct Sent {
    vec3 radiance;
    vec3 passed;
    vec3 onward;
};
Sent sentBack(Ray ray, Hit hit)
{
    Instance placed = rayInstances[rayTriangles[hit.triangle].instance];
    MetPoint met = metPoint(hit.triangle, hit.barycentric);
    Surface s = metSurface(kTextures, materials[placed.material], met, ray.direction);
    Bsdf b = s.bsdf; // in a frame of its own: an anisotropic lobe keeps its shape

    ShadedPoint p;
    p.position = s.position;
    p.off = s.meetingError;
    p.normal = s.frame.normal;
    p.bent = hasNormalMap(placed.material);
    p.face = s.geometricNormal;
    p.toEye = -ray.direction;
    p.roughness = sqrt(sqrt(b.alpha.x * b.alpha.y));
    p.lightmapUv = met.uv1 * placed.lightmapScale + placed.lightmapOffset;
    p.page = placed.lightmap < 0 ? kGBufferNoPage : s.frontFacing > 0.0 ? uint(placed.lightmap) : kGBufferBackPage;
    p.open = 1.0;
    p.mirrored = 0u;

    vec3 wo = localEye(s.frame, p.toEye);
    Sent sent;
    sent.radiance = sumOf(leavingLight(b, s.frame, wo, p)) + s.emission + s.unlit;
    sent.passed = b.transmission * layerPass(b, wo.z);
    sent.onward = leaving(s, -s.geometricNormal);
    return sent;
}

// Straight through clear surfaces, as an eye sees them.
vec3 radianceAlong(Ray ray, out float nearness)
{
    const int kSurfaces = 5; // two bodies of glass, and what lies behind them
    vec3 sum = vec3(0.0), passed = vec3(1.0);
    nearness = 0.0;
    for (int k = 0; k < kSurfaces && passed != vec3(0.0); ++k) {
        Hit hit = closestHit(ray);
        if (!(hit.distance < kRayFar)) {
            vec3 sky = skyRadianceFrom(ray.direction, lighting.skyRadiance, lighting.skyRotation, kSkyImage);
            return sum + passed * sky;
        }
        if (k == 0) nearness = 1.0 / max(hit.distance, 1.0 / kHalfMax);
        Sent sent = sentBack(ray, hit);
        sum += passed * sent.radiance;
        passed *= sent.passed;
        ray.origin = sent.onward;
    }
    return sum;
}

float depthAt(ivec2 pixel) { return texelFetch(depthTexture, clamp(pixel, ivec2(0), reflection.size - 1), 0).r; }
vec3 positionAt(ivec2 pixel, float depth) { return worldFromDepth((vec2(pixel) + 0.5) / vec2(reflection.size), depth, reflection.clipToWorld); }

// Where the next pixel's surface would lie, were it that of this one.
vec3 stepAlong(ivec2 axis, ivec2 pixel, float depth, vec3 position)
{
    bool first = pixel != max(pixel, axis), last = pixel + axis != min(pixel + axis, reflection.size - 1);
    float slope = slopeOf(depthAt(pixel - axis), depth, depthAt(pixel + axis), first, last);
    return positionAt(pixel + axis, max(depth + slope, 1e-9)) - position;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    traced = uvec4(0u);
    seen = vec4(0.0);
    near = 0.0;
    if (pixel != min(pixel, reflection.size - 1)) return; // the textures are rounded up
    float depth = depthAt(pixel);
    if (!(depth > 0.0)) return;
    uvec4 surface = texelFetch(surfaceTexture, pixel, 0);
    traced = uvec4(0u, 0u, floatBitsToUint(depth), surface.x);
    GBufferTexel t = decodeGBuffer(surface);
    if (!mirrors(t)) return;

    // No ray goes into the face that it leaves, as those about a bent normal might
    vec3 position = positionAt(pixel, depth), toEye = directionToEye(position, reflection.eye);
    vec3 across = stepAlong(ivec2(1, 0), pixel, depth, position), down = stepAlong(ivec2(0, 1), pixel, depth, position);
    vec3 face = faceNormal(across, down, t.normal, toEye), normal = visibleNormal(t.normal, t.normal, toEye);
    if (dot(face, normal) < kOneSurface) face = normal;
    vec3 direction = mirrorDirection(toEye, normal);
    direction = normalize(direction + face * max(-dot(direction, face), 0.0));
    float distance_ = viewRay((vec2(pixel) + 0.5) / vec2(reflection.size), depth, reflection.clipToWorld, reflection.eye).distance;
    vec2 uv = (vec2(pixel) + 0.5) / vec2(reflection.size);
    float cornerError = cornerRounding(position, uv, 1.0 / vec2(reflection.size), depth, reflection.clipToWorld);
    PixelPoint from = PixelPoint(position, cornerError, normal, face, distance_, rayErrors[t.material]);
    vec3 origin = leaving(from, reflection.clipToWorld, reflection.eye);

    vec3 radiance = radianceAlong(Ray(origin, direction, kRayFar), near);
    traced.x = floatBitsToUint(1.0 / max(near, kLeastNearness));
    traced.y = floatBitsToUint(1.0);
    seen = vec4(min(mix(vec3(0.0), radiance, greaterThan(radiance, vec3(0.0))), vec3(kHalfMax)), 1.0); // a NaN is 0
}
