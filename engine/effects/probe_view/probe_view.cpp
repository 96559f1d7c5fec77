#include "engine/effects/probe_view/probe_view.hpp"
#include "engine/baked/probe_cell.hpp"
#include "engine/graph/draw.hpp"
#include <algorithm>

namespace afterglow
{
std::vector<ProbeMark> probeMarks(const ProbeTree& tree)
{
    std::vector<ProbeMark> marks;
    for (const vec3& position : tree.positions) marks.push_back({position, kFloatMax, 0.0f});
    for (const ProbeCell& cell : tree.cells) {
        const vec3 extent = extentOf(cell);
        float least = kFloatMax;
        for (int axis = 0; axis < 3; axis++)
            if (extent[axis] > 0.0f) least = std::min(least, extent[axis]);
        for (uint corner = 0; corner < 8; corner++) {
            ProbeMark& mark = marks[cell.probe[corner]];
            const vec3 place = cell.lower + extent * vec3(corner & 1u, corner >> 1u & 1u, corner >> 2u);
            mark.radius = std::min(mark.radius, kSphereOfCell * least);
            mark.moved = std::max(mark.moved, distance(mark.position, place) / std::max(length(extent), 1e-6f));
        }
    }
    for (ProbeMark& mark : marks)
        if (mark.radius == kFloatMax) mark.radius = 0.0f; // of flat cells alone, or of none
    return marks;
}

static ProbeViewFrame frameOf(const View& view, const GpuLevel& level, uint shown)
{
    return {
        view.worldToClip, view.clipToWorld, view.rayEye(), vec2(view.size), pixelWidth(view), shown, uint(level.baked.reflections.size())};
}

Texture probeView(Graph& graph, const View& view, const GBuffer& surfaces, const GpuLevel& level, const GpuBuffer& marks,
                  const Texture& image, uint shown)
{
    const Buffer frame = graph.upload("probe view", frameOf(view, level, shown));
    Texture picture = image;
    if (showsColors(shown)) {
        picture = graph.texture("probe view", image.format(), image.size());
        graph.fullscreen("probe_view.surfaces", "engine/effects/probe_view/surface.frag")
            .read(frame)
            .read(surfaces.surface)
            .read(surfaces.depth)
            .write(picture);
    }
    if (showsSpheres(shown)) {
        Pass pass = graph.raster("probe_view", "engine/effects/probe_view/probe_view.vert", "engine/effects/probe_view/probe_view.frag");
        pass.read(frame).read(graph.import(marks)).modify(picture).modify(surfaces.depth);
        const uint count = uint(marks.bytes / sizeof(ProbeMark));
        pass.draw([count](Draw& draw) { draw.vertices(6 * count); });
    }
    return picture;
}
}
