#include "engine/effects/shading.hpp"
#include "engine/effects/shading.h"

namespace afterglow
{
void shade(Pass& pass, const Shadows& shadows, const Buffer& frame, const GpuLevel& level, const LightingParts& parts)
{
    pass.specialize(kLightingLightmaps, parts.lightmaps ? uint(level.baked.lightmaps.size()) : 0u);
    pass.specialize(kLightingDirectional, parts.directional);
    pass.specialize(kLightingProbes, parts.probes && bool(level.baked.probeTree));
    pass.specialize(kLightingReflections, parts.reflections ? uint(level.baked.reflections.size()) : 0u);
    pass.specialize(kLightingLights, uint(level.scene.runtimeLights.size())).specialize(kLightingSunMaps, shadows.sunMaps);
    pass.specialize(kLightingMedia, parts.fog ? level.scene.mediumCount() : 0u);
    pass.read(shadows.atlas, Sampler::shadow).read(shadows.views).read(shadows.first).read(frame);
}
}
