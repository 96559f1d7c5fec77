#include "engine/effects/surface_draws.hpp"
#include "engine/effects/surface_push.h"
#include "shaders/gbuffer.h"
#include <algorithm>
#include <cmath>

namespace afterglow
{
namespace
{
SurfacePush pushOf(const View& view, const GpuScene& scene, const DrawItem& item)
{
    const Instance& instance = item.instance;
    SurfacePush push;
    push.objectToClip = mat4(dmat4(view.worldToClip) * dmat4(mat4(instance.toWorld)));
    push.objectToWorld = mat3(instance.toWorld);
    push.lightmapScale = instance.lightmapScale;
    push.lightmapOffset = instance.lightmapOffset;
    push.material = instance.material;
    push.page = instance.lightmap >= 0 ? uint(instance.lightmap) : kGBufferNoPage;
    push.object = instance.object;
    if (!view.mirrored.empty() && view.mirrored[std::size_t(&item - scene.draws.data())]) push.page |= kPushMirrored;
    return push;
}

// A bound of how much a linear map stretches, exact without shear: the largest row sum of m^T m is no less than its largest eigenvalue.
float largestScale(const mat3& m)
{
    const mat3 squares = transpose(m) * m;
    float largest = 0.0f;
    for (int i = 0; i < 3; ++i) largest = std::max(largest, dot(abs(squares[i]), vec3(1.0f)));
    return std::sqrt(largest);
}

// Distance from the eye to the box, or along the view for an orthographic eye.
float nearness(const View& view, const DrawItem& item)
{
    if (view.eye.w == 0.0f) return -dot(vec3(view.eye), 0.5f * (item.lower + item.upper));
    return distance(clamp(vec3(view.eye), item.lower, item.upper), vec3(view.eye));
}

// How far the normals of a draw may turn, radians: matte light changes by about as much, and a highlight by its share of the lobe's width,
// which is no narrower than what a pixel sees of a round body (geometry/geometry.frag). `pixels`: of a metre of its own space.
float mayTurn(const DrawItem& item, float pixels)
{
    const float kChange = 0.25f;                                                       // lods/README.md has what others do
    const float radius = 0.5f * distance(item.objectLower, item.objectUpper) * pixels; // px
    const float width = std::sqrt(item.alpha * item.alpha + 1.0f / (radius * radius));
    return kChange * width / (1.0f + width);
}
}

CoarserLevel levelFor(const View& view, const DrawItem& item)
{
    CoarserLevel drawn{item.instance.firstIndex, item.instance.indexCount, 0.0f};
    if (!(view.mayStray > 0.0f) || item.coarser.empty()) return drawn;
    const float pixels = pixelsPerMetre(view, item.lower, item.upper) * largestScale(mat3(item.instance.toWorld));
    const float turn = mayTurn(item, pixels);
    for (const CoarserLevel& level : item.coarser)
        if (level.error * pixels <= view.mayStray && level.turn <= turn) drawn = level;
    return drawn;
}

std::function<void(Draw&)> surfaceDraws(const GpuScene& scene, const View& view, DrawKind kind, Order order)
{
    return [&scene, view, kind, order](Draw& draw) {
        std::vector<std::pair<float, const DrawItem*>> seen;
        for (const DrawItem& item : scene.draws)
            if (item.kind == kind && mayBeSeen(view.worldToClip, item.lower, item.upper)) seen.emplace_back(nearness(view, item), &item);
        std::stable_sort(seen.begin(), seen.end(), [order](const auto& a, const auto& b) {
            return order == Order::nearFirst ? a.first < b.first : a.first > b.first;
        });
        if (seen.empty()) return;
        draw.indices(scene.indices);
        for (const auto& [distance, item] : seen) drawSurface(draw, scene, view, *item);
    };
}

void drawIndices(Draw& draw, const View& view, const DrawItem& item)
{
    const CoarserLevel level = levelFor(view, item);
    draw.frontsOnly(item.closed && isBeyondNear(view.worldToClip, item.lower, item.upper));
    draw.indexed(level.indexCount, level.firstIndex, int(item.instance.firstVertex));
}

void drawSurface(Draw& draw, const GpuScene& scene, const View& view, const DrawItem& item)
{
    draw.push(pushOf(view, scene, item));
    drawIndices(draw, view, item);
}
}
