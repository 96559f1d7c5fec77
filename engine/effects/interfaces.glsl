// What the interfaces of a surface (metal, dielectric layer) send to the eye of light that comes from about the mirror direction. Lighting
// takes that light from the probes, reflection from the picture.
#ifndef AFTERGLOW_INTERFACES_GLSL
#define AFTERGLOW_INTERFACES_GLSL
#include "shaders/bindings.glsl"
#include "shaders/bsdf.h"

// The G-buffer keeps no tangent: an anisotropic lobe is drawn round, with the same area.
Bsdf roundBsdf(Bsdf b)
{
    b.alpha = vec2(sqrt(b.alpha.x * b.alpha.y));
    return b;
}

// Normal maps and interpolation may tilt a normal away from the eye: the surface is then seen edge-on rather than from behind.
vec3 localEye(Frame frame, vec3 toEye)
{
    vec3 wo = toLocal(frame, toEye);
    wo.z = max(wo.z, 1e-3);
    return normalize(wo);
}

bool hasInterface(Bsdf b) { return b.metallic > 0.0 || b.layerEdge > 0.0; }

// Of light from the whole lobe, by the table that goes with prefiltered cubemaps.
vec3 splitSumShare(Bsdf b, float cosEye, float roughness)
{
    vec2 terms = textureLod(splitSum, splitSumUv(cosEye, roughness), 0.0).rg;
    vec3 metal = b.metal * terms.x + terms.y, layer = b.layer * terms.x + b.layerEdge * terms.y;
    return b.metallic * metal + (1.0 - b.metallic) * layer;
}

#endif
