#include "engine/core/error.hpp"
#include "engine/effects/shadow/shadow.hpp"
#include "engine/effects/tracing.hpp"

namespace afterglow
{
Texture tracedShadows(Graph& graph, const View& view, const GBuffer& surfaces, const GpuScene& scene, const ShadowParameters& parameters)
{
    constexpr uint kLayer = 4; // lights
    const uint lights = uint(scene.runtimeLights.size());
    if (lights == 0 || !scene.rays) return {};
    const auto array = [&](const char* name) {
        return graph.texture(name, ImageShape{.format = VK_FORMAT_R8G8B8A8_UNORM,
                                              .size = {view.size, 1},
                                              .layers = (lights + kLayer - 1) / kLayer,
                                              .kind = ImageKind::array});
    };
    check(parameters.rays > 0 && parameters.rays % kFirstShadowRays == 0, "the first rays lie in one quarter of a light each");
    const bool denoise = parameters.denoise > 0;
    const Texture traced = array("traced shadows"), denoised = denoise ? array("denoised shadows") : traced;
    for (uint layer = 0; layer < traced.layers(); ++layer) {
        const auto named = [&](const std::string& name) { return layer == 0 ? name : name + "." + std::to_string(layer); };
        Pass pass = graph.fullscreen(named("shadow.rays"), "engine/effects/shadow/rays.frag");
        traces(pass, scene.rays).read(surfaces.surface).read(surfaces.depth).specialize(kShadowNoise, denoise);
        pass.push(ShadowTrace{view.clipToWorld, view.eye, layer * kLayer, lights, parameters.rays, view.frame});
        pass.write(traced.layer(layer));
        if (!denoise) continue;
        const Texture noise = graph.texture(named("shadow noise"), traced.format(), view.size);
        pass.write(noise);
        graph.fullscreen(named("shadow.denoise"), "engine/effects/shadow/denoise.frag")
            .read(surfaces.depth)
            .read(traced.layer(layer))
            .read(noise)
            .write(denoised.layer(layer))
            .push(ShadowDenoise{metresOfDepth(view), pixelWidth(view), float(view.resting + 1)});
    }
    return denoised;
}
}
