// What a level calls for, and why, in words: the baker runs only those stages, the runtime builds only those effects.
#pragma once
#include "engine/scene/scene.hpp"
#include <string>
#include <string_view>
#include <vector>

namespace afterglow
{
// `reason` reads after "effect: on, " or "effect: off, ".
struct Need {
    std::string effect;
    bool on = false;
    std::string reason;
};

// First the baker's stages (lightmaps, what they say of directions, probes, reflections, lods, voxels), then the runtime's effects
// (geometry, shadow, lighting, reflection, fog, occlusion, planar, portal, toon, outline, bloom, display). Always all of them, in this
// order. `directAll`: of a bake that holds the direct part of every light, those too that say ag_bake = none.
std::vector<Need> needs(const Scene& scene, bool directAll = false);

// Whether light falls on it about the normals of a normal map.
bool isBent(const Material& material);

// The need of that name; asking for one that does not exist is a programmer's error.
const Need& need(const std::vector<Need>& all, std::string_view effect);
}
