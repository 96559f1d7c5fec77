// The geometry pass: every opaque surface once, into the G-buffer.
#pragma once
#include "engine/effects/view.hpp"

namespace afterglow
{
struct GeometryParts {
    bool masked = false;   // the level has alpha masks
    bool emission = false; // the level has emissive or unlit surfaces
    bool objects = false;  // something tells objects apart
    bool facets = false;   // the level has rough metals
};

GBuffer geometry(Graph& graph, const View& view, const GpuScene& scene, const GeometryParts& parts);
}
