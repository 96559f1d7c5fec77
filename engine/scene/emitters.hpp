// The emissive triangles of a level as a table of lights, chosen in proportion to their power: the same for both tracers.
#pragma once
#include "engine/scene/scene.hpp"
#include "shaders/emitter.h"

namespace afterglow
{
struct EmitterTable {
    std::vector<Emitter> emitters; // in the order of the level's triangles
    std::vector<float> density;    // Emitter::density by the tracer's triangle; empty when nothing emits
};

// `order`: of each of the tracer's triangles its number among all triangles of `placed`, one instance after another.
EmitterTable emitterTable(const Scene& scene, const std::vector<Instance>& placed, const std::vector<uint>& order);
}
