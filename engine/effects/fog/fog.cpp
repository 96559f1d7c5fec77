#include "engine/effects/fog/fog.hpp"
#include "engine/core/error.hpp"

namespace afterglow
{
Texture fog(Graph& graph, const View& view, const GBuffer& surfaces, const Shadows& shadows, const GpuLevel& level, const vec3& ambient,
            const Texture& image, const FogParameters& parameters)
{
    check(parameters.steps > 0 && parameters.divisor > 0, "a fog march needs steps and a resolution");
    const uvec2 size = image.size();
    const Buffer frame = graph.upload("fog", FogFrame{view.clipToWorld, view.rayEye(), ambient, uint(level.scene.runtimeLights.size()),
                                                      level.scene.mediumCount(), level.baked.probeBoxCount, parameters.steps,
                                                      parameters.divisor, ivec2(size)});
    const Texture scattered =
        graph.texture("scattered", VK_FORMAT_R16G16B16A16_SFLOAT, (size + parameters.divisor - 1u) / parameters.divisor);
    const Texture foggy = graph.texture("foggy", image.format(), size);

    graph.fullscreen("fog.march", "engine/effects/fog/march.frag")
        .read(shadows.atlas, Sampler::shadow)
        .read(shadows.views)
        .read(shadows.first)
        .read(frame)
        .read(surfaces.depth)
        .write(scattered)
        .specialize(kFogSunMaps, shadows.sunMaps)
        .specialize(kFogProbes, level.baked.probeBoxCount > 0);
    graph.fullscreen("fog", "engine/effects/fog/fog.frag").read(frame).read(surfaces.depth).read(image).read(scattered).write(foggy);
    return foggy;
}
}
