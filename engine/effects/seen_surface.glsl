// A surface as an eye meets it, for every pass that weighs what it sends there.
#ifndef AFTERGLOW_SEEN_SURFACE_GLSL
#define AFTERGLOW_SEEN_SURFACE_GLSL
#include "shaders/bindings.glsl"
#include "shaders/frame.h"
#include "shaders/gbuffer.h"
#include "shaders/surface.h"

// The G-buffer keeps no tangent: an anisotropic lobe is drawn round, with the same area.
float roundRoughness(Material m, float roughness)
{
    vec2 alpha = roughnessToAlpha(roughness, m.anisotropy);
    return sqrt(sqrt(alpha.x * alpha.y));
}

// The law of a surface as makeBsdf() has it.
Bsdf roundBsdf(Material m, vec4 baseColor, vec2 roughMetal, float transmission, bool entering)
{
    roughMetal.x = roundRoughness(m, roughMetal.x);
    m.anisotropy = 0.0;
    return makeBsdf(m, baseColor, roughMetal, transmission, entering);
}

// Of what the G-buffer holds. Its lobe is as wide as the pixel's normals make it, but those lose nothing to each other: light is lost, and
// comes back, between facets as rough as `facets`, the material's own roughness.
Bsdf seenBsdf(GBufferTexel t, float facets)
{
    Material m = materials[t.material];
    Bsdf b = roundBsdf(m, vec4(t.baseColor, 1.0), vec2(t.roughness, t.metallic), 0.0, true);
    float roughness = roundRoughness(m, facets);
    if (b.metallic > 0.0) b.facets = facetLossOf(vec2(roughness * roughness));
    return b;
}

// Normal maps and interpolation may tilt a normal away from the eye: the surface is then seen edge-on rather than from behind.
vec3 localEye(Frame frame, vec3 toEye)
{
    vec3 wo = toLocal(frame, toEye);
    wo.z = max(wo.z, 1e-3);
    return normalize(wo);
}

#endif
