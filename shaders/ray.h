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
    float meetingError;   // m, by how much rays may miss the plane of its triangle
    vec3 geometricNormal; // unit, on the side of the viewer
    Frame frame;          // its normal is the shading normal, on the side of the viewer
    vec3 emission;        // radiance towards the viewer
    vec3 unlit;           // radiance that only a camera sees (KHR_materials_unlit)
    float frontFacing;    // 1: the viewer is on the front side
    vec3 absorption;      // 1/m, of the body that the viewer looks through when it is on the inner side of glass; else 0
    Bsdf bsdf;            // in the local frame
};

// How far off a triangle's plane a ray may meet it that begins near it, m; corners from where it begins. A tracer turns or crosses
// differences of corners in floats, whose rounding goes with the farthest one, not with where the ray is.
FN float meetingError(vec3 a, vec3 b, vec3 c)
{
    const float kOfReach = 2.384185791015625e-7f; // 4 x 2^-24. Experiment, plates turned at will: 1 for Embree, 2 for an Nvidia H100
    vec3 reach = max(abs(a), max(abs(b), abs(c)));
    return kOfReach * max(reach.x, max(reach.y, reach.z));
}

// Where a ray begins that leaves the surface on the side of `normal`, a geometric one.
FN vec3 leaving(IN(Surface) surface, vec3 normal) { return leaving(surface.position, surface.meetingError, normal); }

SHARED_END
#endif
