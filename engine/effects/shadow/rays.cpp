#include "engine/effects/shadow/shadow.hpp"
#include "engine/effects/tracing.hpp"

namespace afterglow
{
Texture tracedShadows(Graph& graph, const View& view, const GBuffer& surfaces, const GpuScene& scene, const ShadowParameters& parameters)
{
    constexpr uint kLayer = 4; // lights
    const uint lights = uint(scene.runtimeLights.size());
    if (lights == 0 || !scene.rays) return {};
    const ImageShape shape{
        .format = VK_FORMAT_R8G8B8A8_UNORM, .size = {view.size, 1}, .layers = (lights + kLayer - 1) / kLayer, .kind = ImageKind::array};
    const Texture traced = graph.texture("traced shadows", shape);
    for (uint layer = 0; layer < shape.layers; ++layer) {
        const std::string name = layer == 0 ? "shadow.rays" : "shadow.rays." + std::to_string(layer);
        Pass pass = graph.fullscreen(name, "engine/effects/shadow/rays.frag");
        traces(pass, scene.rays).read(surfaces.surface).read(surfaces.depth);
        pass.push(ShadowTrace{view.clipToWorld, view.eye, layer * kLayer, lights, parameters.rays, view.frame});
        pass.write(traced.layer(layer));
    }
    return traced;
}
}
