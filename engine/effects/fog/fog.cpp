#include "engine/effects/fog/fog.hpp"
#include "engine/core/error.hpp"

namespace afterglow
{
namespace
{
// Edge of a texel of the march: its clip space is 2 high.
float texelEdge(const View& view, uint divisor)
{
    const vec3 up(view.worldToClip[0][1], view.worldToClip[1][1], view.worldToClip[2][1]);
    return 2.0f * float(divisor) / (length(up) * float(view.size.y));
}

// The parts of the picture, each dimmed, and what the air adds.
void fogLayers(Graph& graph, const Buffer& known, const GBuffer& surfaces, const Texture& scattered, const GpuScene& scene, Layers& layers)
{
    const auto part = [&](const char* name) { return graph.texture(name, VK_FORMAT_R16G16B16A16_SFLOAT, layers.direct.size()); };
    Layers dimmed = layers;
    dimmed.direct = part("dimmed direct");
    dimmed.indirect = part("dimmed indirect");
    dimmed.reflection = part("dimmed mirrored");
    dimmed.emission = part("dimmed emitted");
    dimmed.fog = part("fog layer");
    Pass pass = graph.fullscreen("fog.layers", "engine/effects/fog/layers.frag");
    pass.read(known).read(surfaces.depth).read(scattered).specialize(kFogEmission, scene.mediumEmits);
    pass.specialize(kFogMedia, scene.mediumCount());
    pass.read(layers.direct).read(layers.indirect).read(layers.reflection).read(layers.emission);
    writeAll(pass, dimmed);
    pass.write(dimmed.fog);
    layers = dimmed;
}

void remember(FogMemory& memory, const View& view)
{
    const bool still = memory.view.steady == view.steady && memory.view.size == view.size;
    memory.remembered = min(memory.remembered + 1, still ? kFogRememberedStill : kFogRemembered);
    memory.view = view;
    ++memory.frames;
}
}

Texture fog(Graph& graph, FogMemory* memory, const View& view, const GBuffer& surfaces, const Shadows& shadows, const GpuLevel& level,
            const vec3& ambient, const Texture& image, const FogParameters& parameters, Layers* layers)
{
    check(parameters.steps > 0 && parameters.divisor > 0, "a fog march needs steps and a resolution");
    const uvec2 size = image.size();
    const View before = memory && memory->frames > 0 ? memory->view : view;
    const float shift = fogShift(memory ? memory->frames : view.frame);
    if (memory) remember(*memory, view);

    FogFrame frame{};
    frame.clipToWorld = view.clipToWorld;
    frame.worldToClipBefore = before.worldToClip;
    frame.eye = view.rayEye();
    frame.eyeBefore = before.eye;
    frame.ambient = ambient;
    frame.steps = parameters.steps;
    frame.divisor = parameters.divisor;
    frame.size = ivec2(size);
    frame.shift = shift;
    frame.share = memory ? 1.0f / float(memory->remembered) : 1.0f;
    frame.texel = texelEdge(view, parameters.divisor);
    const Buffer known = graph.upload("fog", frame);
    // In full floats: a device may round halves towards zero, and what is remembered would fade
    const VkFormat format = VK_FORMAT_R32G32B32A32_SFLOAT;
    const uvec2 coarse = (size + parameters.divisor - 1u) / parameters.divisor;
    const History scattered = memory ? graph.history("scattered", format, coarse) : History{{}, graph.texture("scattered", format, coarse)};
    const Texture foggy = graph.texture("foggy", image.format(), size);

    graph.fullscreen("fog.march", "engine/effects/fog/march.frag")
        .read(shadows.atlas, Sampler::shadow)
        .read(shadows.views)
        .read(shadows.first)
        .read(known)
        .read(surfaces.depth)
        .read(scattered.previous)
        .write(scattered.current)
        .specialize(kFogSunMaps, shadows.sunMaps)
        .specialize(kFogMemory, memory != nullptr)
        .specialize(kFogProbes, bool(level.baked.probeTree))
        .specialize(kFogLights, uint(level.scene.runtimeLights.size()))
        .specialize(kFogMedia, level.scene.mediumCount());
    graph.fullscreen("fog", "engine/effects/fog/fog.frag")
        .read(known)
        .read(surfaces.depth)
        .read(image)
        .read(scattered.current)
        .write(foggy)
        .specialize(kFogMedia, level.scene.mediumCount())
        .specialize(kFogEmission, level.scene.mediumEmits);
    if (layers) fogLayers(graph, known, surfaces, scattered.current, level.scene, *layers);
    return foggy;
}
}
