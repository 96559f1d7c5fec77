// The smallest level that shaders/portals.h can be compiled with: nothing is met.
#ifndef AFTERGLOW_TEST_DIALECT_PORTALS_H
#define AFTERGLOW_TEST_DIALECT_PORTALS_H
#include "shaders/picture.h"
SHARED_BEGIN

struct Tracer {
    uint rays;
};
struct PortalSet {
    uint count;
};

FN Hit closestHit(Tracer, Ray) { return Hit(kRayFar, 0u, vec2(0.0f)); }
FN int portalMet(PortalSet, Hit) { return -1; }
FN Portal portalAt(PortalSet, uint)
{
    Portal nothing;
    return nothing;
}

SHARED_END
#endif
