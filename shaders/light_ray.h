// The ray that asks whether a light sample reaches a point: one law for the path estimator and for the frame.
#ifndef AFTERGLOW_LIGHT_RAY_H
#define AFTERGLOW_LIGHT_RAY_H
#include "shaders/light.h"
#include "shaders/path.h"
#include "shaders/ray.h"
SHARED_BEGIN

// `origin`: the point `position` pushed off its surface. From there the ray is aimed anew at the point that `light` samples as seen from
// `position` (a shifted ray would meet a ceiling that its light lies in), and stops short of it. far <= 0: the light touches the point.
FN Ray rayToLight(vec3 position, vec3 origin, IN(LightSample) light)
{
    vec3 toLight = position + light.direction * light.distance - origin;
    float distance_ = length(toLight), stop = distance_ - max(distance_ * kShadowShortening, length(origin - position));
    bool ends = light.distance < kRayFar;
    return Ray(origin, mix(light.direction, toLight / distance_, bvec3(ends && stop > 0.0f)), ends ? stop : kRayFar);
}

SHARED_END
#endif
