// Portals: where the picture of the eye beyond one is looked up.
#ifndef AFTERGLOW_PORTAL_H
#define AFTERGLOW_PORTAL_H
#include "shaders/glsl.h"
SHARED_BEGIN

struct PortalFrame {
    ivec2 corner; // of the picture beyond in the picture, px
};

const uint kPortalLayers = 0u; // specialization constant: the layers of the picture are attachments, too

struct PortalParameters {
    uint depth; // through how many portals a look may go, 0..8; the last shows its own surface
};
FN PortalParameters defaultPortalParameters()
{
    PortalParameters p;
    p.depth = 1u;
    return p;
}
const uint kDeepestPortal = 8u;

SHARED_END
#endif
