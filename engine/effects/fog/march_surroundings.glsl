// The light from everywhere in the air, as far as the probes know it.
#ifndef AFTERGLOW_FOG_MARCH_SURROUNDINGS_GLSL
#define AFTERGLOW_FOG_MARCH_SURROUNDINGS_GLSL
#include "engine/effects/fog/march.glsl"

// Mean radiance around a point, by the probes: of the box that holds it, or of the border of the nearest.
vec3 surrounding(vec3 position)
{
    vec3 mean = fog.ambient;
    float nearest = kFloatMax;
    for (uint i = 0u; i < kProbeBoxes; ++i) {
        vec3 unitPosition = probeBoxes[i].toUnit * vec4(position, 1.0);
        vec3 outside = mat3(probeBoxes[i].toWorld) * max(abs(unitPosition) - 0.5, vec3(0.0));
        if (dot(outside, outside) >= nearest) continue;
        nearest = dot(outside, outside);
        vec3 n = vec3(probeBoxes[i].count); // texel centres are probes: n - 1 cells between the first and the last
        mean = textureLod(meanRadiance[i], 0.5 + clamp(unitPosition, -0.5, 0.5) * (n - 1.0) / n, 0.0).rgb;
    }
    return mean;
}

// Light from everywhere scatters as its mean: a phase function integrates to 1.
Scattered scatteredFromSurroundings(Crossing c, ViewRay ray, float within)
{
    float step_ = spanLength(c.span) / float(kFogSurroundings);
    Scattered s = Scattered(vec3(0.0), 0.0);
    vec3 tau0 = min(depthToEye(c, ray, 0.0), vec3(kFogBlack)), e0 = exp(-tau0);
    for (uint k = 0u; k < kFogSurroundings; ++k) {
        float way = float(k + 1u) * step_, t = c.span.begin + way + (within - 1.0) * step_;
        vec3 tau1 = min(depthToEye(c, ray, way), vec3(kFogBlack)), e1 = exp(-tau1);
        vec3 mean = kProbeBoxes > 0u ? surrounding(ray.origin + ray.direction * t) : fog.ambient;
        vec3 arriving = mean * meanOfExponentials(tau0, tau1, e0, e1);
        s.radiance += arriving;
        s.moment += arriving.g * t;
        tau0 = tau1;
        e0 = e1;
    }
    return Scattered(s.radiance * c.m.scattering * step_, s.moment * c.m.scattering.g * step_);
}

#endif
