// The attachments beside the picture when its layers are asked for (engine/effects/layers.hpp), filled by the passes that light surfaces.
#ifndef AFTERGLOW_LIT_LAYERS_GLSL
#define AFTERGLOW_LIT_LAYERS_GLSL
#include "engine/effects/shading.glsl"

layout(constant_id = kLightingLayers) const uint kLayers = kLayersNone;

layout(location = 1) out vec4 reflectionLayer;
layout(location = 2) out vec4 directLayer;
layout(location = 3) out vec4 indirectLayer;
layout(location = 4) out vec4 emissionLayer;

// `coverage`: the share of the pixel that sends this light; `alpha`: how much it hides of what lies behind.
void writeLayers(LeavingLight light, vec3 emission, float coverage, float alpha)
{
    if (kLayers == kLayersNone) return;
    reflectionLayer = vec4(min(light.reflection, vec3(kHalfMax)) * coverage, alpha);
    if (kLayers == kLayersMirrored) return;
    directLayer = vec4(min(light.direct, vec3(kHalfMax)) * coverage, alpha);
    indirectLayer = vec4(min(light.indirect, vec3(kHalfMax)) * coverage, alpha);
    emissionLayer = vec4(min(emission, vec3(kHalfMax)) * coverage, alpha);
}

#endif
