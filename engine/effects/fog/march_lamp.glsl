// A lamp in the air: steps of equal angle about it. What is left for the step count is the shadow's border.
#ifndef AFTERGLOW_FOG_MARCH_LAMP_GLSL
#define AFTERGLOW_FOG_MARCH_LAMP_GLSL
#include "engine/effects/fog/march.glsl"

// Nearer to the ray than its radius a lamp shines as from there; nor nearer than the mean of 1/h over a texel, which is 4 asinh(1) / edge.
float nearestLamp(ViewRay ray, Light light)
{
    float edge = fog.texel * (fog.eye.w > 0.0 ? length(light.position - ray.origin) : 1.0);
    return max(max(light.radius, kMinLightDistance), edge / 3.5255);
}

Scattered scatteredFromLamp(Crossing c, ViewRay ray, Light light, int first, float within)
{
    LampMarch m = lampMarch(ray.origin, ray.direction, c.span, light.position, nearestLamp(ray, light), float(fog.steps));
    bool spot = light.type == kLightSpot;
    ShadowRay shadow;
    if (first >= 0 && spot) shadow = shadowRay(shadowViews[first], ray.origin, ray.direction);
    Air air = Air(kMedia);
    bool inside = spanLength(mediumSpan(air, c.m, light.position, vec3(0.0), 1.0)) > 0.0; // the lamp, in the medium
    float angle = m.first + within * m.step_;
    vec2 turn = vec2(cos(m.step_), sin(m.step_)), at = vec2(cos(angle), sin(angle)); // cosine and sine, turned step by step
    Scattered s = Scattered(vec3(0.0), 0.0);
    for (uint k = 0u; k < fog.steps; ++k) {
        float cosine = max(at.x, 1e-6), sine = at.y;
        float t = clamp(m.along + m.h * sine / cosine, c.span.begin, c.span.end);
        vec3 position = ray.origin + ray.direction * t;
        vec3 offset = light.position - position;
        float distance_ = length(offset);
        vec3 toLight = distance_ > 0.0 ? offset / distance_ : -ray.direction;
        float lit = 1.0;
        if (first >= 0)
            lit = spot ? shadowTap(shadow, shadowAtlas, t)
                       : shadowTap(shadowViews[first + int(shadowFace(position - light.position))], shadowAtlas, position);
        float way = max(distance_ - light.radius, 0.0); // from the lamp's surface
        float own = inside ? way : spanLength(mediumSpan(air, c.m, position, toLight, way));
        vec3 depth = depthToEye(c, ray, t - c.span.begin) + opticalDepth(c.sigmaT, own) + othersDepth(c.medium, position, toLight, way);
        vec3 arriving = lightIntensity(light, toLight, distance_) * exp(-min(depth, vec3(kFogBlack)));
        float g = c.m.g;
        if (light.radius > 0.0) {
            arriving *= sphereFluence(light.radius, distance_) * m.h * m.h / (cosine * cosine); // in place of a point's 1/r^2
            g *= sphereMeanCosine(light.radius, distance_);
        }
        arriving *= phaseHg(g, -sine) * lit; // the cosine between ray and light is -sine
        s.radiance += arriving;
        s.moment += arriving.g * t;
        at = vec2(at.x * turn.x - at.y * turn.y, at.y * turn.x + at.x * turn.y);
    }
    vec3 unit = c.m.scattering * (m.step_ / m.h);
    return Scattered(s.radiance * unit, s.moment * unit.g);
}

#endif
