// Raster shadow maps of every light that the runtime adds: one map for a sun or a spot, six for a point light, in one atlas.
// A level holds still, so the atlas outlives the frame: it is drawn once, and again when something moves (set `drawn` to false).
// In a level that is large for one map a sun has cascades, too: maps that follow the eye, drawn again when they have moved.
#pragma once
#include "engine/effects/shadow/shadow.h"
#include "engine/effects/shadows.hpp"
#include "engine/effects/view.hpp"

namespace afterglow
{
struct Cascade {
    std::size_t map;  // of ShadowMaps::maps
    mat4 level;       // where the same sun's map of the whole level looks
    float half;       // of the map's edge, m
    vec3 levelMiddle; // m
};

struct ShadowMaps {
    GpuImage atlas; // absent: no light casts
    GpuBuffer views, first;
    std::vector<ShadowView> maps;
    std::vector<uvec4> areas;      // of each map in the atlas: x, y, width, height
    std::vector<vec2> furthest;    // of each map: ShadowPush
    uvec2 extent{0};               // of the atlas, texels
    uint sunMaps = 1;              // of each sun: its cascades, the finest first, then the map of the whole level
    std::vector<Cascade> cascades; // of all suns
    bool masked = false;           // some caster has an alpha mask
    bool drawn = false;
};

// A directional light's map: an orthographic box around `lower`..`upper` as the light sees it. Stable for any direction.
mat4 sunClip(const Light& sun, const std::vector<DrawItem>& draws);
mat4 spotClip(const Light& spot);
mat4 faceClip(const Light& point, int face, float texels);

// Halves of the edges of the cascades for a level `diagonal` m across, the finest first; each at most four times the one before.
std::vector<float> cascadeHalves(float diagonal, const ShadowParameters& parameters);

// A cascade's box: what is in view near the eye. It moves in steps of 1/16 of its edge, so that its texels stay where they are.
mat4 cascadeClip(const Cascade& cascade, const View& view);

enum class SunMaps { level, cascades }; // of a sun: one of the whole level, or cascades before it

// Places maps for the lights. A map whose share of the atlas would pass 8192 texels on a side is halved until all fit.
ShadowMaps makeShadowMaps(Gpu& gpu, const GpuScene& scene, const ShadowParameters& parameters, SunMaps sun = SunMaps::level);

// Turns a map to where its matrix looks; `parallel`: along the rays of a sun.
void aim(ShadowMaps& maps, std::size_t map, const mat4& worldToClip, bool parallel);

Shadows shadow(Graph& graph, ShadowMaps& maps, const GpuScene& scene, const View& view);

enum class ShadowMethod {
    map, // what a light sees, drawn once
    ray  // ray queries from every pixel's surface, the lights in their size
};

// The share of each light that reaches the surface at each pixel, by ray query: RGBA8, a layer for four lights. Absent without lights, or
// where there is nothing to meet (scene.rays).
Texture tracedShadows(Graph& graph, const View& view, const GBuffer& surfaces, const GpuScene& scene, const ShadowParameters& parameters);
}
