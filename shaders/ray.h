// What travels between a tracer and the path estimator: a ray, what it met, and the surface there.
#ifndef AFTERGLOW_RAY_H
#define AFTERGLOW_RAY_H
#include "shaders/bsdf.h"
#include "shaders/frame.h"
#include "shaders/glsl.h"
SHARED_BEGIN

const float kRayFar = 1e30f; // m: further than any level

struct Ray {
    vec3 origin;    // world, m; already pushed off its surface (offsetRay of frame.h)
    vec3 direction; // unit
    float far;      // m
};

// The nearest hit, as the tracer reports it.
struct Hit {
    float distance;   // m along the ray; kRayFar: nothing was met
    uint triangle;    // index in the tracer's own order
    vec2 barycentric; // of the second and third vertex
};

// A shading point. Every direction here points away from the surface.
struct Surface {
    vec3 position;        // world, m
    vec3 geometricNormal; // unit, on the side of the viewer
    Frame frame;          // its normal is the shading normal, on the side of the viewer
    vec3 emission;        // radiance towards the viewer
    vec3 unlit;           // radiance that only a camera sees (KHR_materials_unlit)
    float frontFacing;    // 1: the viewer is on the front side
    vec3 absorption;      // 1/m, of the body that the viewer looks through when it is on the inner side of glass; else 0
    Bsdf bsdf;            // in the local frame
};

SHARED_END
#endif
