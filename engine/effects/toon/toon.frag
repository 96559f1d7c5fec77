#version 460
// Surfaces that answer light in steps, drawn over what lighting made of them. Every light has steps of its own: a weak one moves no edge of
// a strong one.
#include "engine/effects/lit_surface.glsl"
#include "engine/effects/toon/toon.h"

layout(set = 1, binding = 8, scalar) readonly buffer Ramps { ToonRamp ramps[]; }; // by material
layout(set = 1, binding = 9, scalar) readonly buffer Steps { ToonStep steps[]; };

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 radiance;

// Whether any of four neighbouring pixels asks: they go on or stop together, so that differences between them stay known.
bool askedNearby(bool asked)
{
    float any_ = asked ? 1.0 : 0.0;
    any_ += abs(dFdxFine(any_));
    any_ += abs(dFdyFine(any_));
    return any_ > 0.0;
}

float widthOf(float x) { return length(vec2(dFdx(x), dFdy(x))); }

vec3 toneOf(ToonRamp ramp, float response)
{
    float width = widthOf(response);
    vec3 tone = steps[ramp.first].tone;
    for (uint i = ramp.first + 1u; i < ramp.first + ramp.steps; ++i)
        tone += (steps[i].tone - steps[i - 1u].tone) * toonShare(response, steps[i].edge, width);
    return tone;
}

// The same colour, as bright as its rung of the ladder.
vec3 onLadder(vec3 light)
{
    float peak = max(largestOf(light), 1e-30), logarithm = log2(peak);
    return light * (toonRung(logarithm, widthOf(logarithm)) / peak);
}

vec3 directSteps(Bsdf b, ToonRamp ramp, ShadedPoint p)
{
    vec3 sum = vec3(0.0), glint = interfaceReflectance(b, 1.0) * toonHighlightRadiance(b.alpha.x);
    for (uint i = 0u; i < kLights; ++i) {
        Light light = lights[i];
        light.radius = 0.0;
        light.sinAngle = 0.0;
        LightSample s = sampleLight(light, p.position, vec2(0.5));
        float cosine = dot(p.normal, s.direction);
        float reaches = cosine > 0.0 ? lightReaches(i, light, p) : 0.0;
        vec3 tone = mix(steps[ramp.first].tone, toneOf(ramp, max(cosine, 0.0)), toonLit(reaches, widthOf(reaches)));
        float height = toonHighlight(max(dot(p.normal, normalize(s.direction + p.toEye)), 0.0), b.alpha.x);
        vec3 arriving = s.radiance;
        if (kMedia > 0u) arriving *= mediaTransmittance(Air(kMedia), p.position, s.direction, s.distance);
        // A sun is as bright everywhere; all else varies with the place
        vec3 rung = onLadder(arriving);
        if (kMedia > 0u || light.type != kLightDirectional) arriving = rung;
        sum += arriving * tone * (b.diffuse * kInvPi + glint * toonShare(height, kToonHighlightEdge, widthOf(height)));
    }
    return sum;
}

// Baked light keeps its shadows, in rungs: on a level whose bake holds the lights themselves they are all that there is to see.
vec3 indirectSteps(Bsdf b, ShadedPoint p)
{
    vec3 irradiance = bakedIrradiance(p), rung = onLadder(irradiance);
    vec3 mirror = p.mirrored == 0u ? interfaceReflectance(b, 1.0) : vec3(0.0); // else an eye behind the mirror sees it
    return (kLightmapPages > 0u || kProbes > 0u ? rung : irradiance) * (b.diffuse + mirror);
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depthTexture, pixel, 0).r;
    GBufferTexel t = decodeGBuffer(texelFetch(surfaceTexture, pixel, 0));
    ToonRamp ramp = ramps[t.material];
    bool inSteps = depth > 0.0 && ramp.steps > 0u;
    if (!askedNearby(inSteps)) discard;

    ShadedPoint p;
    p.position = worldFromDepth(uv, max(depth, 1e-9), lighting.clipToWorld);
    p.normal = t.normal;
    p.bent = hasNormalMap(t.material);
    p.toEye = directionToEye(p.position, lighting.eye);
    vec3 across = dFdx(p.position), down = dFdy(p.position);
    p.face = faceNormal(across, down, p.normal, p.toEye);
    p.off = cornerRounding(p.position, uv, vec2(dFdx(uv.x), dFdy(uv.y)), max(depth, 1e-9), lighting.clipToWorld);
    p.roughness = t.roughness;
    p.lightmapUv = t.lightmapUv;
    p.page = t.page;
    p.open = 1.0; // contact would be a tone of its own
    p.mirrored = t.mirrored;
    Bsdf b = roundBsdf(materials[t.material], vec4(t.baseColor, 1.0), vec2(t.roughness, t.metallic), 0.0, true);

    LeavingLight light;
    light.direct = directSteps(b, ramp, p);
    light.indirect = indirectSteps(b, p);
    light.reflection = vec3(0.0);
    vec3 emission = emissionAt(pixel);
    if (!inSteps) discard;
    radiance = sentBy(sumOf(light) + emission, t.mirrored);
    writeLayers(light, emission, 1.0, 1.0);
    if (kLayers != kLayersNone) reflectionLayer = vec4(0.0); // alpha too: nothing is to be mirrored here
}
