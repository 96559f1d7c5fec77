#include "engine/effects/shading.hpp"
#include "engine/effects/shading.h"

namespace afterglow
{
void shade(Pass& pass, const Shadows& shadows, const Buffer& frame, const GpuLevel& level, const LightingParts& parts)
{
    pass.specialize(kLightingLightmaps, parts.lightmaps ? uint(level.baked.lightmaps.size()) : 0u);
    pass.specialize(kLightingProbes, parts.probes);
    pass.specialize(kLightingReflections, parts.reflections);
    pass.specialize(kLightingSunMaps, shadows.sunMaps).specialize(kLightingFog, parts.fog);
    pass.read(shadows.atlas, Sampler::shadow).read(shadows.views).read(shadows.first).read(frame);
}
}
