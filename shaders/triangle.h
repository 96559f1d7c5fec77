// What a ray meets of one triangle. The tracers have tests of their own, in trees; this is what they are held against.
// This work is based on: Moeller & Trumbore 1997.
#ifndef AFTERGLOW_TRIANGLE_H
#define AFTERGLOW_TRIANGLE_H
#include "shaders/ray.h"
SHARED_BEGIN

// Distance along the ray, m; kRayFar where it passes by. Both sides count.
FN float triangleDistance(Ray ray, vec3 a, vec3 b, vec3 c)
{
    // origin + t direction = a + u (b - a) + v (c - a), by Cramer's rule
    const vec3 ab = b - a, ac = c - a, from = ray.origin - a;
    const vec3 p = cross(ray.direction, ac), q = cross(from, ab);
    const float inverse = 1.0f / dot(ab, p); // infinite where they are parallel: no comparison below then holds
    const float u = dot(from, p) * inverse, v = dot(ray.direction, q) * inverse, t = dot(ac, q) * inverse;
    return u >= 0.0f && v >= 0.0f && u + v <= 1.0f && t > 0.0f && t < ray.far ? t : kRayFar;
}

SHARED_END
#endif
