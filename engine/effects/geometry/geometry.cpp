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
    if (parts.objects) g.objects = graph.texture("objects", VK_FORMAT_R32_UINT, view.size);
    if (parts.facets) g.facets = graph.texture("facets", VK_FORMAT_R8_UNORM, view.size);
    const auto specialize = [&](Pass pass) {
        pass.specialize(kGeometryEmission, parts.emission).specialize(kGeometryObjects, parts.objects);
        return pass.specialize(kGeometryFacets, parts.facets).specialize(kTextureBias, view.textureBias).push(SurfacePush{});
    };

    Pass opaque = specialize(graph.raster("geometry", vertexShader, fragmentShader));
    opaque.write(g.surface).write(g.emission).write(g.objects).write(g.facets).write(g.depth);
    opaque.draw(surfaceDraws(scene, view, DrawKind::opaque, Order::nearFirst));

    if (parts.masked) {
        Pass masked = specialize(graph.raster("geometry.masked", vertexShader, fragmentShader)).specialize(kGeometryMasked, true);
        masked.modify(g.surface).modify(g.emission).modify(g.objects).modify(g.facets).modify(g.depth);
        masked.draw(surfaceDraws(scene, view, DrawKind::masked, Order::nearFirst));
    }
    return g;
}
}
