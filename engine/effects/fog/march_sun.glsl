// Parallel light in the air: steps of equal length, each integrated as if the optical depth to the eye and to the light ran linearly along
// it, which it does. What is left for the step count is the shadow's border.
#ifndef AFTERGLOW_FOG_MARCH_SUN_GLSL
#define AFTERGLOW_FOG_MARCH_SUN_GLSL
#include "engine/effects/fog/march.glsl"

// Where parallel light enters the medium on its way to a point of the ray: the distances to the box's faces are affine in the way.
struct Entry {
    vec3 toLight;
    vec3 faces; // m, from where the ray enters
    vec3 slope;
};
Entry makeEntry(Crossing c, ViewRay ray, vec3 toLight)
{
    Entry e = Entry(toLight, vec3(kFloatMax), vec3(0.0));
    vec3 position = ray.origin + ray.direction * c.span.begin;
    for (int a = 0; a < 3; ++a) {
        if (toLight[a] == 0.0) continue;
        float face = toLight[a] > 0.0 ? c.m.upper[a] : c.m.lower[a], apart = face - position[a];
        // What the ray and the light enter by alike is no rounding apart
        e.faces[a] = abs(apart) > kFogRounding * (abs(face) + c.span.begin) ? apart / toLight[a] : 0.0;
        e.slope[a] = -ray.direction[a] / toLight[a];
    }
    return e;
}
float crossed(Crossing c, Entry e, vec3 position, float way)
{
    vec3 to = e.faces + e.slope * way;
    Span s = Span(0.0, max(min(min(to.x, to.y), to.z), 0.0));
    for (uint i = 0u; i < c.m.planeCount; ++i) s = planeSpan(s, position, e.toLight, mediumPlanes[c.m.firstPlane + i]);
    return spanLength(s);
}

// The finest of a sun's maps that holds the point.
int sunMap(int first, vec3 position)
{
    int last = first + int(kSunMaps) - 1;
    while (first < last && !(cascadeShare(shadowViews[first], position) > 0.0)) ++first;
    return first;
}

Scattered scatteredFromSun(Crossing c, ViewRay ray, Light light, int first, float within)
{
    bool oneMap = first >= 0 && kSunMaps == 1u;
    ShadowRay shadow;
    if (oneMap) shadow = shadowRay(shadowViews[first], ray.origin, ray.direction);
    float step_ = spanLength(c.span) / float(fog.steps);
    vec3 toLight = -light.direction;
    Entry entry = makeEntry(c, ray, toLight);
    Scattered s = Scattered(vec3(0.0), 0.0);
    vec3 tau0, e0;
    for (uint k = 0u; k <= fog.steps; ++k) {
        float way = float(k) * step_;
        vec3 border = ray.origin + ray.direction * (c.span.begin + way);
        vec3 depth = depthToEye(c, ray, way) + opticalDepth(c.sigmaT, crossed(c, entry, border, way));
        depth += othersDepth(c.medium, border, toLight, kFloatMax);
        vec3 tau1 = min(depth, vec3(kFogBlack)), e1 = exp(-tau1);
        if (k > 0u) {
            // The shadow is asked for where the share `within` of the step's light lies before, so that shifts average to its integral
            float t = c.span.begin + way - step_ * (1.0 - shareOfStep(tau1.g - tau0.g, within));
            float lit = oneMap ? shadowTap(shadow, shadowAtlas, t) : 1.0;
            if (first >= 0 && !oneMap) {
                vec3 position = ray.origin + ray.direction * t;
                lit = shadowTap(shadowViews[sunMap(first, position)], shadowAtlas, position);
            }
            vec3 arriving = lit * meanOfExponentials(tau0, tau1, e0, e1);
            s.radiance += arriving;
            s.moment += arriving.g * t;
        }
        tau0 = tau1;
        e0 = e1;
    }
    vec3 unit = light.intensity * c.m.scattering * (step_ * phaseHg(c.m.g, -dot(ray.direction, light.direction)));
    return Scattered(s.radiance * unit, s.moment * unit.g);
}

#endif
