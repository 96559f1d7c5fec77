// The ray that asks whether a light sample reaches a point: one law for the path estimator and for the frame.
#ifndef AFTERGLOW_LIGHT_RAY_H
#define AFTERGLOW_LIGHT_RAY_H
#include "shaders/light.h"
#include "shaders/path.h"
#include "shaders/ray.h"
SHARED_BEGIN

// `origin`: the point `position` pushed off its surface. From there the ray is aimed anew at the point that `light` samples as seen from
// `position` (a shifted ray would meet a ceiling that its light lies in), and stops short of it. far <= 0: the light touches the point.
FN Ray rayToLight(vec3 position, vec3 origin, LightSample light)
{
    Ray ray = Ray(origin, light.direction, kRayFar);
    if (!(light.distance < kRayFar)) return ray;
    vec3 toLight = position + light.direction * light.distance - origin;
    float distance_ = length(toLight);
    ray.far = distance_ - max(distance_ * kShadowShortening, length(origin - position));
    if (ray.far > 0.0f) ray.direction = toLight / distance_;
    return ray;
}

SHARED_END
#endif
