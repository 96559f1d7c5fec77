#include "engine/effects/portal/portal.hpp"
#include "engine/effects/surface_push.h"

namespace afterglow
{
namespace
{
// One pass a portal: its surface once more, in the same place. Without a portal in view it draws nothing.
void open(Graph& graph, const std::string& name, const View& eye, const GBuffer& surfaces, const GpuScene& scene,
          const VirtualPicture& picture, FlatPart part, const Texture& image, const Layers& layers)
{
    const Flat* flat = picture.from.flat;
    const Buffer frame = flat ? graph.upload(name, PortalFrame{picture.from.corner}) : Buffer{};
    Pass pass = graph.raster(name, "engine/effects/surface.vert", "engine/effects/portal/portal.frag");
    pass.read(frame).read(picture.radiance).modify(image);
    modifyAll(pass.specialize(kPortalLayers, bool(layers.direct)), layers);
    pass.test(surfaces.depth).push(SurfacePush{});
    if (flat) pass.draw(flatDraws(scene, eye, *flat, part));
}
}

void portal(Graph& graph, const View& eye, const GBuffer& surfaces, const GpuScene& scene, const std::vector<VirtualPicture>& pictures,
            FlatPart part, const Texture& image, const Layers& layers)
{
    eachInPlace("portal", pictures, scene, part, [&](const std::string& pass, const VirtualPicture& picture) {
        open(graph, pass, eye, surfaces, scene, picture, part, image, layers);
    });
}
}
