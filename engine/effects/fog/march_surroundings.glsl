// The light from everywhere in the air, as far as the probes know it.
#ifndef AFTERGLOW_FOG_MARCH_SURROUNDINGS_GLSL
#define AFTERGLOW_FOG_MARCH_SURROUNDINGS_GLSL
#include "engine/effects/fog/march.glsl"
#include "shaders/probes.glsl"

// Light from everywhere scatters as its mean: a phase function integrates to 1.
Scattered scatteredFromSurroundings(Crossing c, ViewRay ray, float within)
{
    float step_ = spanLength(c.span) / float(kFogSurroundings);
    Scattered s = Scattered(vec3(0.0), 0.0);
    vec3 tau0 = min(depthToEye(c, ray, 0.0), vec3(kFogBlack)), e0 = exp(-tau0);
    for (uint k = 0u; k < kFogSurroundings; ++k) {
        float way = float(k + 1u) * step_, t = c.span.begin + way + (within - 1.0) * step_;
        vec3 tau1 = min(depthToEye(c, ray, way), vec3(kFogBlack)), e1 = exp(-tau1);
        vec3 mean = kProbes > 0u ? probeMeanRadiance(ProbeSet(kProbes), ray.origin + ray.direction * t) : fog.ambient;
        vec3 arriving = mean * meanOfExponentials(tau0, tau1, e0, e1);
        s.radiance += arriving;
        s.moment += arriving.g * t;
        tau0 = tau1;
        e0 = e1;
    }
    return Scattered(s.radiance * c.m.scattering * step_, s.moment * c.m.scattering.g * step_);
}

#endif
