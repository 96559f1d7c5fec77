// What shaders/transport.h asks of its includer: the runtime's twin of baker/tracer.hpp. Including this file is including the estimator.
// The includer says before how rays are asked: Hit closestHit(Ray) (shaders/trace.glsl, or programs.glsl) and vec3 unshadowed(Ray, vec3
// carried).
#ifndef AFTERGLOW_TRUTH_TRACER_GLSL
#define AFTERGLOW_TRUTH_TRACER_GLSL
#include "engine/effects/truth/truth.h"
#include "shaders/emitter.h"
#include "shaders/media.glsl"
#include "shaders/met.glsl"

layout(constant_id = kTruthLights) const bool kLights = false;
layout(constant_id = kTruthEmitters) const bool kEmitters = false;
layout(constant_id = kTruthSky) const uint kSky = 0u;
layout(constant_id = kTruthMedia) const bool kMedia = false;
layout(constant_id = kTruthGlow) const bool kGlow = false;
layout(constant_id = kTruthPortals) const bool kPortals = false;

layout(set = 1, binding = 0, scalar) readonly buffer Frame_ { TruthFrame frame; };
layout(set = 1, binding = 1, scalar) readonly buffer PathLights { Light pathLights[]; };
layout(set = 1, binding = 2, scalar) readonly buffer Emitters { Emitter emitters[]; };
layout(set = 1, binding = 3, scalar) readonly buffer Densities { float densities[]; };
layout(set = 1, binding = 4, scalar) readonly buffer SkyRows { float skyRows[]; };
layout(set = 1, binding = 5) uniform sampler2D skyTexels;
layout(set = 1, binding = 6, scalar) readonly buffer Portals { Portal portals[]; };
layout(set = 1, binding = 7, scalar) readonly buffer PortalOf { int portalOf[]; };

struct Tracer {
    uint lights; // that next-event estimation asks
};

// Emissive triangles
struct EmitterSet {
    uint count;
};
uint emitterCount(EmitterSet all) { return all.count; }
Emitter emitterAt(EmitterSet all, uint i) { return emitters[i]; }
float emitterDensity(EmitterSet all, uint triangle) { return densities[triangle]; }
vec3 emissionAt(EmitterSet all, uint triangle, vec2 barycentric)
{
    return metEmission(kTextures, materialOf(triangle), metPoint(triangle, barycentric));
}
#include "shaders/emitter_choice.h"

EmitterSet allEmitters() { return EmitterSet(kEmitters ? frame.emitters : 0u); }
LightSample sampleEmitter(Tracer tracer, vec3 from, float choice, vec2 u) { return sampleEmitters(allEmitters(), from, choice, u); }
float emitterPdf(Tracer tracer, Ray ray, Hit hit, Surface surface) { return emittersPdf(allEmitters(), ray, hit, surface); }

// The sky
struct SkyMap {
    ivec2 size;
    vec3 tint;
    float rotation;
    uint sampled;
};
vec3 skyTexel(SkyMap sky, ivec2 texel) { return texelFetch(skyTexels, texel, 0).rgb; }
float skyColumn(SkyMap sky, ivec2 texel) { return texelFetch(skyTexels, texel, 0).a; }
float skyRow(SkyMap sky, int y) { return skyRows[y]; }
#include "shaders/sky_light.h"

SkyMap skyMap() { return SkyMap(kSky > 0u ? textureSize(skyTexels, 0) : ivec2(0), frame.skyTint, frame.skyRotation, kSky > 1u ? 1u : 0u); }
vec3 skyRadiance(Tracer tracer, vec3 direction) { return skyMapRadiance(skyMap(), direction); }
LightSample sampleSky(Tracer tracer, vec2 u) { return sampleSkyMap(skyMap(), u); }
float skyPdf(Tracer tracer, vec3 direction) { return skyMapPdf(skyMap(), direction); }

// Lamps
uint lightCount(Tracer tracer) { return kLights ? tracer.lights : 0u; }
Light lightAt(Tracer tracer, uint i) { return pathLights[i]; }
bool hasDirect(Tracer tracer, uint category)
{
    if (category == kDirectPunctual) return lightCount(tracer) > 0u;
    return category == kDirectEmitter ? kEmitters : kSky > 1u;
}

// Surfaces and air
Hit closestHit(Tracer tracer, Ray ray) { return closestHit(ray); }
Surface surfaceAt(Tracer tracer, Ray ray, Hit hit) { return surfaceAt(ray, hit); }
vec3 unshadowed(Tracer tracer, Ray ray, vec3 carried) { return unshadowed(ray, carried); }
Air airOf(Tracer tracer) { return Air(kMedia ? frame.media : 0u); }
bool knownBase(Tracer tracer, Hit hit, Surface surface, out vec3 light)
{
    light = vec3(0.0);
    return false;
}
void cutShort(Tracer tracer) {}
PathSettings settings(Tracer tracer)
{
    PathSettings limits = frame.limits;
    limits.glow = kGlow ? 1u : 0u;
    return limits;
}

// Portals
struct PortalSet {
    uint unused;
};
int portalMet(PortalSet all, Hit hit) { return portalOf[rayTriangles[hit.triangle].instance]; }
Portal portalAt(PortalSet all, uint i) { return portals[i]; }

#include "shaders/portals.h"
#include "shaders/transport.h"

#endif
