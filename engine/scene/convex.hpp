// Whether a mesh is a convex body, and the planes that bound it: then what is inside is known to any ray by a few divisions.
#pragma once
#include "shaders/glsl.h"
#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace afterglow
{
using namespace shared;

constexpr std::size_t kMostPlanes = 64; // a ray pays for each of them at every step of a march

// `corners`: three a triangle. Outward unit normal and distance of each side; none of them where the body is the box around it along the
// axes. Nothing when the mesh is open, not convex, or has more than kMostPlanes sides.
std::optional<std::vector<dvec4>> convexPlanes(const std::vector<dvec3>& corners);
}
