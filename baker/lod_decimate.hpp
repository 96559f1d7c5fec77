// Fewer triangles by half-edge collapse in order of quadric error: vertices vanish into their neighbours, none is made or moved.
#pragma once
#include "engine/core/progress.hpp"
#include "engine/scene/scene.hpp"
#include <span>

namespace afterglow
{
struct DecimationInput {
    std::span<const Vertex> vertices;
    std::span<const uint> indices;
    std::vector<bool> locked; // per vertex: its point is shared with another primitive, and must stay
    double maxError = 1e300;  // m: how far a collapse may stray, root mean square over the planes it meets
    double uvDrift = 0.0;     // how far a seam may stray in uv0 and uv1, all its collapses together
    Advance gone = unheard;   // triangles
};

// One list of indices per target (triangles, falling): at most as many, or as few as the rules allow. The rules: closed sheets stay closed,
// borders slide along straight stretches of themselves only, seams (of uv, normal, colour) within uvDrift, no triangle turns over in
// space or in uv.
std::vector<std::vector<uint>> decimate(const DecimationInput& input, const std::vector<std::size_t>& targets);
}
