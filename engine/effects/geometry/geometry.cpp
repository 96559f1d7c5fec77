#include "engine/effects/geometry/geometry.hpp"
#include "engine/effects/geometry/geometry.h"
#include "engine/effects/surface_draws.hpp"
#include "engine/effects/surface_push.h"

namespace afterglow
{
GBuffer geometry(Graph& graph, const View& view, const GpuScene& scene, const GeometryParts& parts)
{
    const char* vertexShader = "engine/effects/surface.vert";
    const char* fragmentShader = "engine/effects/geometry/geometry.frag";
    GBuffer g;
    g.surface = graph.texture("surface", VK_FORMAT_R32G32B32A32_UINT, view.size);
    g.depth = graph.texture("depth", VK_FORMAT_D32_SFLOAT, view.size);
    if (parts.emission) g.emission = graph.texture("emission", VK_FORMAT_R16G16B16A16_SFLOAT, view.size);

    Pass opaque = graph.raster("geometry", vertexShader, fragmentShader);
    opaque.write(g.surface).write(g.depth).specialize(kGeometryEmission, parts.emission).push(SurfacePush{});
    opaque.draw(surfaceDraws(scene, view, DrawKind::opaque, Order::nearFirst));
    if (g.emission) opaque.write(g.emission);

    if (parts.masked) {
        Pass masked = graph.raster("geometry.masked", vertexShader, fragmentShader);
        masked.modify(g.surface).modify(g.depth).specialize(kGeometryMasked, true).specialize(kGeometryEmission, parts.emission);
        masked.push(SurfacePush{}).draw(surfaceDraws(scene, view, DrawKind::masked, Order::nearFirst));
        if (g.emission) masked.modify(g.emission);
    }
    return g;
}
}
