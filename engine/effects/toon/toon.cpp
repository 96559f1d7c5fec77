#include "engine/effects/toon/toon.hpp"
#include "engine/effects/shading.h"
#include "engine/scene/scene.hpp"

namespace afterglow
{
ToonRamps toonRamps(const Scene& scene, const ToonParameters& parameters)
{
    ToonRamps result;
    std::vector<ToonStep> ofLevel = scene.display.toonRamp;
    for (uint i = 0; ofLevel.size() < parameters.steps && scene.display.toonRamp.empty(); ++i)
        ofLevel.push_back(evenToonStep(i, parameters.steps));
    const auto add = [&result](const std::vector<ToonStep>& steps) {
        const ToonRamp ramp{uint(result.steps.size()), uint(steps.size())};
        result.steps.insert(result.steps.end(), steps.begin(), steps.end());
        return ramp;
    };
    const ToonRamp common = add(ofLevel);
    result.ofMaterial.assign(std::max<std::size_t>(scene.materials.size(), 1),
                             scene.display.toon || parameters.everyone != 0u ? common : ToonRamp{0, 0});
    for (const auto& [material, steps] : scene.toonRamps) result.ofMaterial[material] = add(steps);
    return result;
}

void toon(Graph& graph, const GBuffer& surfaces, const Shadows& shadows, const GpuLevel& level, const Lit& lit, const LightingParts& parts,
          const ToonRamps& ramps, const Layers* layers)
{
    Pass pass = graph.fullscreen("toon", "engine/effects/toon/toon.frag");
    shade(pass, shadows, lit.frame, level, parts);
    pass.specialize(kLightingEmission, bool(surfaces.emission)).specialize(kLightingTraced, bool(shadows.traced));
    pass.read(surfaces.surface).read(surfaces.depth).read(surfaces.emission).read(shadows.traced);
    pass.read(graph.upload("toon ramps", std::span<const ToonRamp>(ramps.ofMaterial)));
    pass.read(graph.upload("toon steps", std::span<const ToonStep>(ramps.steps))).modify(lit.radiance);
    if (layers)
        modifyAll(pass.specialize(kLightingLayers, kLayersAll), *layers);
    else if (parts.mirrored)
        pass.specialize(kLightingLayers, kLayersMirrored).modify(lit.mirrored);
}
}
