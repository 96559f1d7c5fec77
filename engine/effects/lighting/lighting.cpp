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
LightingFrame frameOf(const View& view, const Surroundings& surroundings)
{
    LightingFrame frame;
    frame.clipToWorld = view.clipToWorld;
    frame.eye = view.eye;
    frame.ambient = surroundings.ambient;
    frame.skyRotation = surroundings.skyRotation;
    frame.skyRadiance = surroundings.skyRadiance;
    frame.size = vec2(view.size);
    return frame;
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

Lit lighting(Graph& graph, const View& view, const GBuffer& surfaces, const Shadows& shadows, const Texture& visibility,
             const GpuLevel& level, const Surroundings& surroundings, const LightingParts& parts, Layers* layers)
{
    const auto picture = [&](const char* name) { return graph.texture(name, VK_FORMAT_R16G16B16A16_SFLOAT, view.size); };
    Lit lit;
    lit.radiance = picture("radiance");
    if (layers || parts.mirrored) lit.mirrored = picture("mirrored");
    if (layers)
        *layers = {
            .direct = picture("direct"), .indirect = picture("indirect"), .reflection = lit.mirrored, .emission = picture("emitted")};
    lit.frame = graph.upload("lighting", frameOf(view, surroundings));

    Pass pass = graph.fullscreen("lighting", "engine/effects/lighting/lighting.frag");
    shade(pass, shadows, lit.frame, level, parts);
    pass.specialize(kLightingEmission, bool(surfaces.emission)).specialize(kLightingSkyImage, bool(level.scene.skyImage));
    pass.specialize(kLightingTraced, bool(shadows.traced)).specialize(kLightingOcclusion, bool(visibility));
    pass.specialize(kLightingFacets, bool(surfaces.facets));
    pass.read(surfaces.surface).read(surfaces.depth).read(surfaces.emission).read(shadows.traced).read(visibility).read(surfaces.facets);
    pass.write(lit.radiance);
    if (layers)
        writeAll(pass.specialize(kLightingLayers, kLayersAll), *layers);
    else if (parts.mirrored)
        pass.specialize(kLightingLayers, kLayersMirrored).write(lit.mirrored);
    return lit;
}

void clearSurfaces(Graph& graph, const View& view, const GBuffer& surfaces, const Shadows& shadows, const GpuLevel& level, const Lit& lit,
                   const LightingParts& parts, Layers* layers)
{
    Pass pass = graph.raster("lighting.clear", "engine/effects/surface.vert", "engine/effects/lighting/clear.frag");
    shade(pass, shadows, lit.frame, level, parts);
    pass.modify(lit.radiance).specialize(kTextureBias, view.textureBias);
    if (layers) modifyAll(pass.specialize(kLightingLayers, kLayersAll), *layers);
    pass.test(surfaces.depth).blend(Blend::alpha).push(SurfacePush{});
    pass.draw(surfaceDraws(level.scene, view, DrawKind::clear, Order::farFirst));
}
}
