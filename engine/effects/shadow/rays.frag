#version 460
// The share of four lights that reaches the surface at a pixel: one ray to a light without a size; to one that has a size four, and as many
// as are asked for where those disagree.
#include "engine/effects/shadow/shadow.h"
#include "engine/effects/turn.h"
#include "engine/effects/view_ray.h"
#include "shaders/color.h"
#include "shaders/gbuffer.h"
#include "shaders/light_ray.h"
#include "shaders/random.h"
#include "shaders/trace.glsl"

layout(push_constant, scalar) uniform Push { ShadowTrace push; };
layout(set = 1, binding = 0) uniform usampler2D surfaceTexture;
layout(set = 1, binding = 1) uniform sampler2D depthTexture;
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 reaches;
layout(location = 1) out vec4 noise; // standard deviation of the shares, twice
layout(constant_id = kShadowNoise) const bool kNoise = false;

struct Lit {
    float passed;  // of the weights
    float squared; // the same, of the squares of what passed
    float weight;  // cosines
};

// Rays from..to - 1 of the sequence.
Lit ask(Light light, uint from, uint to, uint seed, vec3 position, vec3 origin, vec3 normal)
{
    Lit lit = Lit(0.0, 0.0, 0.0);
    for (uint i = from; i < to; ++i) {
        Sampler random = makeSampler(seed, i);
        LightSample s = sampleLight(light, position, next2(random));
        float weight = max(dot(s.direction, normal), 0.0);
        if (!(weight > 0.0)) continue;
        Ray ray = rayToLight(position, origin, s);
        float passed = ray.far > 0.0 ? luminance(transmittance(ray)) : 1.0;
        lit.weight += weight;
        lit.passed += weight * passed;
        lit.squared += weight * passed * passed;
    }
    return lit;
}

// Whether the light shines on this side of the surface at all, in reach and in its cone.
bool shines(Light light, vec3 position, vec3 normal)
{
    light.radius = light.sinAngle = 0.0;
    LightSample s = sampleLight(light, position, vec2(0.5));
    return s.radiance != vec3(0.0) && dot(s.direction, normal) > 0.0;
}

float shareOf(Lit lit) { return lit.weight > 0.0 ? clamp(lit.passed / lit.weight, 0.0, 1.0) : 0.0; }

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depthTexture, pixel, 0).r;
    vec3 position = worldFromDepth(uv, max(depth, 1e-9), push.clipToWorld);
    vec3 across = dFdx(position), down = dFdy(position); // here, where the sky's pixels still are neighbours
    bool sky = !(depth > 0.0);
    GBufferTexel t = decodeGBuffer(texelFetch(surfaceTexture, pixel, 0));
    vec3 normal = t.normal, face = faceNormal(across, down, normal, directionToEye(position, push.eye));
    float distance_ = viewRay(uv, depth, push.clipToWorld, push.eye).distance;
    float cornerError = cornerRounding(position, uv, vec2(dFdx(uv.x), dFdy(uv.y)), max(depth, 1e-9), push.clipToWorld);
    PixelPoint from = PixelPoint(position, cornerError, normal, face, distance_, sky ? 0.0 : rayErrors[t.material]);
    vec3 origin = leaving(from, push.clipToWorld, push.eye);
    uint last = min(push.first + 4u, push.lights);
    reaches = vec4(1.0);
    noise = vec4(0.0);
    for (uint i = push.first; i < last; ++i) {
        Light light = lights[i];
        bool sized = !isDeltaLight(light);
        uint seed = kNoise ? hash2(push.seed, i) : hash3(uint(pixel.x), uint(pixel.y), i + push.seed);
        uint first = kNoise ? turnIndex(pixel, 0) * push.rays : 0u, asked = sized ? kFirstShadowRays : 1u;
        bool asks = !sky && shines(light, position, normal);
        Lit lit = Lit(0.0, 0.0, 0.0);
        if (asks) lit = ask(light, first, first + asked, seed, position, origin, normal);
        float share = shareOf(lit);
        // The pixels beside it have asked as many others: where any two disagree there may be a penumbra
        const float kAgree = 1e-3;
        bool penumbra = fwidth(share) > kAgree || (share > kAgree && share < 1.0 - kAgree);
        if (asks && sized && penumbra) {
            Lit more = ask(light, first + kFirstShadowRays, first + push.rays, seed, position, origin, normal);
            lit = Lit(lit.passed + more.passed, lit.squared + more.squared, lit.weight + more.weight);
            share = shareOf(lit);
            asked = push.rays;
        }
        reaches[i - push.first] = share;
        if (!kNoise || !sized || !(lit.weight > 0.0)) continue;
        noise[i - push.first] = 2.0 * sqrt(max(lit.squared / lit.weight - share * share, 0.0) / float(asked - 1u));
    }
}
