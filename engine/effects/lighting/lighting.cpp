#include "engine/effects/lighting/lighting.hpp"
#include "engine/effects/lighting/lighting.h"
#include "engine/effects/surface_draws.hpp"
#include "engine/effects/surface_push.h"
#include "shaders/gbuffer.h"
#include "shaders/light.h"

namespace afterglow
{
namespace
{
LightingFrame frameOf(const View& view, const GpuLevel& level, const Surroundings& surroundings)
{
    LightingFrame frame;
    frame.clipToWorld = view.clipToWorld;
    frame.eye = view.eye;
    frame.ambient = surroundings.ambient;
    frame.skyRotation = surroundings.skyRotation;
    frame.skyRadiance = surroundings.skyRadiance;
    frame.lights = uint(level.scene.runtimeLights.size());
    frame.probeBoxes = level.baked.probeBoxCount;
    frame.reflections = uint(level.baked.reflections.size());
    frame.media = level.scene.mediumCount();
    frame.size = vec2(view.size);
    return frame;
}

// The variants and bindings that shading.glsl asks of both passes.
void shade(Pass& pass, const Shadows& shadows, const Buffer& frame, const GpuLevel& level, const LightingParts& parts)
{
    pass.specialize(kLightingLightmaps, parts.lightmaps ? uint(level.baked.lightmaps.size()) : 0u);
    pass.specialize(kLightingProbes, parts.probes && level.baked.probes);
    pass.specialize(kLightingReflections, parts.reflections && !level.baked.reflections.empty());
    pass.specialize(kLightingSunMaps, shadows.sunMaps).specialize(kLightingFog, parts.fog);
    pass.read(shadows.atlas, Sampler::shadow).read(shadows.views).read(shadows.first).read(frame);
}
}

vec3 meanSky(const Sky& sky)
{
    if (sky.image.pixels.empty()) return sky.radiance;
    dvec3 sum(0.0);
    for (int y = 0; y < sky.image.height; ++y) {
        dvec3 row(0.0);
        for (int x = 0; x < sky.image.width; ++x) {
            const float* p = sky.image.at(x, y);
            row += sky.image.channels >= 3 ? dvec3(p[0], p[1], p[2]) : dvec3(p[0]);
        }
        sum += row * double(skyTexelSolidAngle(y, sky.image.width, sky.image.height));
    }
    return sky.radiance * vec3(sum * double(kInvFourPi));
}

Texture lighting(Graph& graph, const View& view, const GBuffer& surfaces, const Shadows& shadows, const GpuLevel& level,
                 const Surroundings& surroundings, const LightingParts& parts, Layers* layers)
{
    const auto picture = [&](const char* name) { return graph.texture(name, VK_FORMAT_R16G16B16A16_SFLOAT, view.size); };
    const Texture radiance = picture("radiance");
    if (layers)
        *layers = {.direct = picture("direct"),
                   .indirect = picture("indirect"),
                   .reflection = picture("mirrored"),
                   .emission = picture("emitted")};
    const Buffer frame = graph.upload("lighting", frameOf(view, level, surroundings));

    Pass lit = graph.fullscreen("lighting", "engine/effects/lighting/lighting.frag");
    shade(lit, shadows, frame, level, parts);
    lit.specialize(kLightingEmission, bool(surfaces.emission)).specialize(kLightingSkyImage, bool(level.scene.skyImage));
    lit.read(surfaces.surface).read(surfaces.depth).read(surfaces.emission).write(radiance);
    if (layers) writeAll(lit.specialize(kLightingLayers, true), *layers);

    if (parts.clear) {
        Pass clear = graph.raster("lighting.clear", "engine/effects/surface.vert", "engine/effects/lighting/clear.frag");
        shade(clear, shadows, frame, level, parts);
        clear.modify(radiance).specialize(kTextureBias, view.textureBias);
        if (layers) modifyAll(clear.specialize(kLightingLayers, true), *layers);
        clear.test(surfaces.depth).blend(Blend::alpha).push(SurfacePush{});
        clear.draw(surfaceDraws(level.scene, view, DrawKind::clear, Order::farFirst));
    }
    return radiance;
}
}
