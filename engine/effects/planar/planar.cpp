#include "engine/effects/planar/planar.hpp"
#include "engine/effects/planar/planar.h"
#include "engine/effects/surface_push.h"
#include "shaders/gbuffer.h"

namespace afterglow
{
namespace
{
PlanarFrame frameOf(const View& eye, const VirtualView& from)
{
    PlanarFrame frame;
    frame.clipToWorld = eye.clipToWorld;
    frame.eye = eye.eye;
    frame.worldToMirror = from.view.worldToClip;
    frame.mirrorToWorld = from.view.clipToWorld;
    frame.normal = from.side * vec3(from.flat->normal);
    frame.size = vec2(eye.size);
    frame.corner = from.corner;
    frame.mirrored = vec2(from.view.size);
    return frame;
}

// One pass a mirror: its surfaces once more, over what is lit already. Without a mirror in view it draws nothing.
void reflect(Graph& graph, const std::string& name, const View& eye, const GBuffer& surfaces, const GpuScene& scene,
             const VirtualPicture& picture, FlatPart part, const Texture& image, const Layers& layers)
{
    const Flat* flat = picture.from.flat;
    const Buffer frame = flat ? graph.upload(name, frameOf(eye, picture.from)) : Buffer{};
    Pass pass = graph.raster(name, "engine/effects/surface.vert", "engine/effects/planar/planar.frag");
    pass.read(frame)
        .read(picture.radiance, Sampler::linear)
        .read(picture.depth)
        .modify(image)
        .modify(layers.reflection)
        .test(surfaces.depth)
        .blend(Blend::alpha);
    pass.specialize(kPlanarRipples, flat && flat->rippled)
        .specialize(kTextureBias, eye.textureBias)
        .specialize(kPlanarLayers, bool(layers.reflection))
        .push(SurfacePush{});
    if (flat) pass.draw(flatDraws(scene, eye, *flat, part));
}
}

void planar(Graph& graph, const View& eye, const GBuffer& surfaces, const GpuScene& scene, const std::vector<VirtualPicture>& pictures,
            FlatPart part, const Texture& image, const Layers& layers)
{
    eachInPlace("planar", pictures, scene, part, [&](const std::string& pass, const VirtualPicture& picture) {
        reflect(graph, pass, eye, surfaces, scene, picture, part, image, layers);
    });
}
}
