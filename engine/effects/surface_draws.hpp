// The draws of the level's surfaces: which may be seen, in what order, with what each pushes.
#pragma once
#include "engine/effects/view.hpp"
#include "engine/graph/draw.hpp"

namespace afterglow
{
enum class Order {
    nearFirst, // what lies behind is never shaded
    farFirst   // what lies before is blended over
};

// For Pass::draw of a pass that uses surface.vert. `scene` must outlive the run.
std::function<void(Draw&)> surfaceDraws(const GpuScene& scene, const View& view, DrawKind kind, Order order);

// The coarsest level of a draw that strays by no more of the picture than the view allows, and whose normals turn by no more than its gloss
// hides; the draw's own without one.
CoarserLevel levelFor(const View& view, const DrawItem& item);

// For passes that draw a surface once more, at the level at which the others drew it; the scene's indices are bound.
void drawIndices(Draw& draw, const View& view, const DrawItem& item);

// With what surface.vert wants to be pushed; the scene's indices are bound.
void drawSurface(Draw& draw, const GpuScene& scene, const View& view, const DrawItem& item);
}
