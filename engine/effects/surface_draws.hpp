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

// One of them; the scene's indices are bound.
void drawSurface(Draw& draw, const GpuScene& scene, const View& view, const DrawItem& item);
}
