#version 460
// What lies beyond a portal, pixel by pixel where the eye looks through it.
#include "engine/effects/portal/portal.h"

layout(set = 1, binding = 0, scalar) uniform Portal { PortalFrame portal; };
layout(set = 1, binding = 1) uniform sampler2D beyond;

layout(constant_id = kPortalLayers) const bool kLayers = false;

layout(location = 0) out vec4 radiance;
layout(location = 1) out vec4 reflectionLayer; // all of what is seen through it: it comes from another place, as in a mirror
layout(location = 2) out vec4 directLayer;
layout(location = 3) out vec4 indirectLayer;
layout(location = 4) out vec4 emissionLayer;

void main()
{
    radiance = vec4(texelFetch(beyond, ivec2(gl_FragCoord.xy) - portal.corner, 0).rgb, 1.0);
    if (!kLayers) return;
    directLayer = indirectLayer = emissionLayer = vec4(vec3(0.0), 1.0);
    reflectionLayer = radiance;
}
