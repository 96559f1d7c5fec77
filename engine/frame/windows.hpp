// Mirrors and portals of a frame: which of them the eye sees, and frames of their own that are made of the same passes.
#pragma once
#include "engine/effects/geometry/geometry.hpp"
#include "engine/effects/virtual_view.hpp"
#include "engine/frame/frame.hpp"

namespace afterglow
{
struct Windows {
    std::vector<VirtualView> mirrors, portals;
    std::size_t left = 0; // how many more pictures the frame may have
};

// As the plan says. A mirror that is seen in a mirror or through a portal keeps its probes: only `eye` itself has mirrors.
Windows windowsOf(const Stage& stage, const View& eye, const Settings& settings);

// `eye`, told which draws are mirrored by another eye.
View marked(View eye, const GpuScene& scene, const std::vector<VirtualView>& mirrors);

// What the plan turns on and the level has.
LightingParts lightingParts(const Stage& stage);
GeometryParts geometryParts(const Stage& stage, const Settings& settings);

// What these eyes see, drawn as passes "planar.0.geometry", "portal.1.lighting" and so on. `left`: Windows::left, which they take from.
std::vector<VirtualPicture> lookThrough(Graph& graph, const Stage& stage, const std::vector<VirtualView>& views, const Shadows& shadows,
                                        const Settings& settings, std::size_t& left);
}
