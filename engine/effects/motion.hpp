// The motion of objects on the screen, for what gathers frames and for compositing.
#pragma once
#include "engine/effects/view.hpp"

namespace afterglow
{
// RGBA32F: where the opaque surfaces that moved were in the last frame (motion.h), by view.last; absent when none did. `name`: of the pass.
Texture movedSurfaces(Graph& graph, const std::string& name, const View& view, const GBuffer& surfaces, const GpuScene& scene);
}
