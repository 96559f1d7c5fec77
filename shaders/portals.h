// A camera's ray that meets the front of a portal goes on from its twin. Only cameras see through portals: light does not pass them, and
// what a medium before one takes of the view is not counted.
// The includer defines, before this line:
//   struct Tracer;  Hit closestHit(Tracer, Ray)
//   struct PortalSet                          what the functions below need, passed by value
//   int    portalMet(PortalSet, Hit)          -1: what was met is none
//   Portal portalAt(PortalSet, uint)
#ifndef AFTERGLOW_PORTALS_H
#define AFTERGLOW_PORTALS_H
#include "shaders/picture.h"
SHARED_BEGIN

// What the ray meets at last; the ray becomes the one that meets it.
FN Hit hitThroughPortals(Tracer tracer, PortalSet portals, INOUT(Ray) ray, uint depth)
{
    Hit hit;
    for (uint passed = 0u;; passed++) {
        hit = closestHit(tracer, ray);
        if (passed >= depth || !(hit.distance < kRayFar)) break;
        int met = portalMet(portals, hit);
        if (met < 0) break;
        Portal portal = portalAt(portals, uint(met));
        if (!(dot(portal.front, ray.direction) < 0.0f)) break;
        vec3 from = portal.through * vec4(ray.origin + hit.distance * ray.direction, 1.0f);
        ray = Ray(offsetRay(from, portal.beyond), normalize(mat3(portal.through) * ray.direction), kRayFar);
    }
    return hit;
}

SHARED_END
#endif
