// Levels of detail by half-edge collapse: every level keeps a subset of its primitive's vertices, so only indices are new.
#pragma once
#include "engine/baked/baked.hpp"
#include "engine/core/progress.hpp"
#include "engine/scene/scene.hpp"
#include <vector>

namespace afterglow
{
struct LodOptions {
    std::vector<float> ratios{0.5f, 0.25f, 0.125f}; // triangles kept, of the primitive's; finest first, (0, 1)
    float maxError = 0.02f;                         // of the diagonal of the mesh's bounding box: coarser levels are not made
    float uvDrift = 0.25f / 1024;                   // uv0, uv1: how far seams and the borders of charts may stray; a quarter of a texel
};

// One entry per mesh. Each level's error bounds its two-sided distance to the primitive, in m of object space; its turn is how its normals
// differ from the primitive's. Primitives that the journal holds are not done again.
class Journal;
std::vector<MeshLods> makeLods(const Scene& scene, const LodOptions& options, int threads, const Advance& advance = unheard, // in triangles
                               Journal* journal = nullptr);
}
