// The probes of a bake as shaders/gpu_baked.h lays them out: what the runtime uploads, and what a lookup on the CPU reads.
#pragma once
#include "engine/baked/baked.hpp"
#include "shaders/gpu_baked.h"

namespace afterglow
{
struct ProbeTables {
    std::vector<ProbeBox> boxes;
    std::vector<Probe> probes; // of all boxes, each from its `first`
};
ProbeTables probeTables(const std::vector<ProbeVolume>& volumes);
}
