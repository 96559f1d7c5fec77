// Blender's Cycles as a lightmap baker: the same mesh, the same texels, driven by its command line.
#pragma once
#include "bench/bench.hpp"

namespace afterglow
{
constexpr int kRoomBounces = 8;

// Two unfiltered bakes of different seeds: {"version","texels","samples","seconds","cpu_seconds","error"}, or {"missing": why}. The lamp
// is the material that shines: a square below the ceiling.
nlohmann::json benchCycles(const Scene& scene, float texelsPerMetre, const BenchOptions& options, const std::filesystem::path& folder);
}
