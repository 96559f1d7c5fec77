// What a path-traced picture needs beside the level itself, of either tracer: its camera's rays, and the portals that they go through.
#pragma once
#include "engine/scene/scene.hpp"
#include "shaders/picture.h"

namespace afterglow
{
struct PortalTable {
    std::vector<Portal> portals;
    std::vector<int> ofInstance; // of instances(scene): the portal that it is, -1: none
};
PortalTable portalTable(const Scene& scene);

// Throws Error when the camera makes no picture.
Picture pictureOf(const Camera& camera, uvec2 size, uint seed, uint portalDepth);
}
