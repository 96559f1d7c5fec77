// The box that stands for what a reflection probe sees: the one by which mirrored rays are looked up least beside themselves.
#pragma once
#include "baker/mirror_rays.hpp"
#include "shaders/reflection.h"
#include <span>

namespace afterglow
{
// How far beside itself what a ray meets is looked up: the chord between unit vectors (radians, while it is small), at most kBeside. As
// wrong is what the probe does not see.
constexpr float kBeside = 1.0f;
float lookupError(const ReflectionBox& box, const MirrorRay& ray, bool isSeen);

// What no box covers mirrors its irradiance: blurred, but light of its own place. Measured: `./run bench --reflections`, by irradiance
// alone.
constexpr float kUncovered = 0.5f;

// Which of the rays meet what is in sight from a point: no box makes up for what is hidden.
std::vector<bool> seenFrom(const World& world, vec3 position, std::span<const MirrorRay> rays);

// A box about `position`. Begins with the walls about it and moves them, one at a time, until no step of a hundredth betters what the rays
// are off by: it covers the places whose mirror images are in sight, and no others. No wall stands
// farther off than a hundred times the level's diagonal; where rays meet the sky alone, those that are not met begin there.
ReflectionBox fitBox(const World& world, vec3 position, std::span<const MirrorRay> rays, const std::vector<bool>& seen);
}
