#include "engine/effects/outline/outline.hpp"
#include "engine/graph/draw.hpp"
#include <algorithm>

namespace afterglow
{
namespace
{
EdgePush pushOf(const View& view, const Instance& instance)
{
    const dmat4 toWorld(mat4(instance.toWorld));
    return {mat4(dmat4(view.worldToClip) * toWorld), vec4(inverse(toWorld) * dvec4(view.eye))};
}

// Of planes seen at 10 degrees; at a flatter look a line in a corner may break. An oblique near plane bends depths: there nothing is known.
vec2 steepestOf(const View& view)
{
    constexpr float kAcross = 2.0f * 5.67f; // px, tangent of 80 degrees
    if (view.fromNear) return vec2(0.0f, 1.0f);
    const mat4& m = view.worldToClip;
    const float pixel = 2.0f / (length(vec3(m[0][1], m[1][1], m[2][1])) * float(view.size.y)); // m at 1 m, or m of an orthographic eye
    return kAcross * pixel * (view.eye.w > 0.0f ? vec2(1.0f, 0.0f) : vec2(0.0f, length(vec3(m[0][2], m[1][2], m[2][2]))));
}

std::function<void(Draw&)> edgeDraws(const GpuScene& scene, const View& view, const GpuEdges& edges)
{
    return [&scene, view, &edges](Draw& draw) {
        for (const EdgeDraw& mesh : edges.draws) {
            const std::span<const DrawItem> items(&scene.draws[mesh.firstItem], mesh.itemCount);
            if (std::none_of(items.begin(), items.end(),
                             [&](const DrawItem& item) { return mayBeSeen(view.worldToClip, item.lower, item.upper); }))
                continue;
            draw.push(pushOf(view, items.front().instance));
            draw.vertices(6 * mesh.count, 1, 6 * mesh.first);
        }
    };
}
}

void outline(Graph& graph, const View& view, const GBuffer& surfaces, const GpuLevel& level, const GpuEdges& edges, const Texture& image,
             const OutlineParameters& parameters, const Layers* layers)
{
    const uvec2 size = image.size();
    const Buffer frame = graph.upload("outline", OutlineFrame{view.clipToWorld, view.rayEye(), parameters.color, parameters.width,
                                                              parameters.kinds, level.scene.mediumCount(), ivec2(size), steepestOf(view)});
    const Texture lines = graph.texture("lines", VK_FORMAT_R8_UNORM, size);

    // Segments overlap at their ends: the one that covers more has the say, or every joint would be a bead
    Pass pass = graph.raster("outline.edges", "engine/effects/outline/edges.vert", "engine/effects/outline/edges.frag");
    pass.read(frame).read(edges.edges ? graph.import(edges.edges) : Buffer{}).read(surfaces.depth).write(lines).blend(Blend::max);
    pass.push(EdgePush{});
    if (parameters.width > 0.0f) pass.draw(edgeDraws(level.scene, view, edges));

    Pass over = graph.fullscreen("outline", "engine/effects/outline/outline.frag");
    over.read(frame).read(lines).read(surfaces.objects).read(surfaces.depth).modify(image).blend(Blend::alpha);
    over.specialize(kOutlineObjects, surfaces.objects && (parameters.kinds & kEdgeObject) != 0);
    if (layers) {
        modifyAll(over.specialize(kOutlineLayers, true), *layers);
        if (layers->fog) over.modify(layers->fog);
    }
}
}
