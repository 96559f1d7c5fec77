// A surface as an eye meets it, for every pass that weighs what it sends there.
#ifndef AFTERGLOW_SEEN_SURFACE_GLSL
#define AFTERGLOW_SEEN_SURFACE_GLSL
#include "shaders/frame.h"
#include "shaders/surface.h"

// The law of a surface as makeBsdf() has it. The G-buffer keeps no tangent: an anisotropic lobe is drawn round, with the same area.
Bsdf roundBsdf(Material m, vec4 baseColor, vec2 roughMetal, float transmission, bool entering)
{
    vec2 alpha = roughnessToAlpha(roughMetal.x, m.anisotropy);
    roughMetal.x = sqrt(sqrt(alpha.x * alpha.y));
    m.anisotropy = 0.0;
    return makeBsdf(m, baseColor, roughMetal, transmission, entering);
}

// Normal maps and interpolation may tilt a normal away from the eye: the surface is then seen edge-on rather than from behind.
vec3 localEye(Frame frame, vec3 toEye)
{
    vec3 wo = toLocal(frame, toEye);
    wo.z = max(wo.z, 1e-3);
    return normalize(wo);
}

#endif
