// Fewer triangles by half-edge collapse in order of quadric error: vertices vanish into their neighbours, none is made or moved.
#pragma once
#include "engine/scene/scene.hpp"
#include <span>

namespace afterglow
{
struct DecimationInput {
    std::span<const Vertex> vertices;
    std::span<const uint> indices;
    std::vector<bool> locked; // per vertex: its point is shared with another primitive, and must stay
};

// One list of indices per target (triangles, falling): at most as many, or as few as the rules allow. The rules: sheets stay closed where
// they were, borders and seams (of uv0, uv1, normal, colour) slide along straight stretches of themselves only, no triangle turns over in
// space or in uv, and no collapse strays more than `maxError` (m, root mean square over the planes it meets).
std::vector<std::vector<uint>> decimate(const DecimationInput& input, const std::vector<std::size_t>& targets, double maxError);
}
