// Raster shadow maps of every light that the runtime adds: one map for a sun or a spot, six for a point light, in one atlas.
// A level holds still, so the atlas outlives the frame: it is drawn once, and again when something moves (set `drawn` to false).
#pragma once
#include "engine/effects/shadow/shadow.h"
#include "engine/effects/shadows.hpp"
#include "engine/effects/view.hpp"

namespace afterglow
{
struct ShadowMaps {
    GpuImage atlas; // absent: no light casts
    GpuBuffer views, first;
    std::vector<ShadowView> maps;
    std::vector<uvec4> areas;   // of each map in the atlas: x, y, width, height
    std::vector<vec2> furthest; // of each map: ShadowPush
    bool masked = false;        // some caster has an alpha mask
    bool drawn = false;
};

// A directional light's map: an orthographic box around `lower`..`upper` as the light sees it. Stable for any direction.
mat4 sunClip(const Light& sun, const std::vector<DrawItem>& draws);
mat4 spotClip(const Light& spot);
mat4 faceClip(const Light& point, int face, float texels);

// Places maps for the lights. A map whose share of the atlas would pass 8192 texels on a side is halved until all fit.
ShadowMaps makeShadowMaps(Gpu& gpu, const GpuScene& scene, const ShadowParameters& parameters);

Shadows shadow(Graph& graph, ShadowMaps& maps, const GpuScene& scene);
}
