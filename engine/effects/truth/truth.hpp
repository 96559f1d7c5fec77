// Truth: the picture path traced on the GPU, with no shortcut and no bake; sample by sample while the camera rests.
#pragma once
#include "engine/effects/truth/truth.h"
#include "engine/effects/view.hpp"
#include "engine/upload/gpu_paths.hpp"
#include <map>
#include <string>

namespace afterglow
{
// How the work is organised. The picture is the same.
enum class Tracing {
    automatic, // as is fastest on the device
    kernel,    // whole paths in one kernel, by ray query
    pipeline,  // whole paths in one ray program, which others answer by way of a shader binding table
    wavefront  // step by step, all paths together: small kernels hand them on in queues
};

// By the words of --tracing.
const std::map<std::string, Tracing>& tracingWords();

bool canTrace(const Device& device, Tracing tracing);

// As asked for, or what is fastest on this device. Throws Error (exit 4) when the device cannot.
Tracing tracingOn(const Device& device, Tracing asked);

// The samples so far. They outlive frames that do not ask for them.
struct TracedSamples {
    GpuImage sum, lost; // lost: to rounding, and made good
    uint count = 0;     // of each pixel; 0 begins a new picture
    TruthFrame of{};
};

// What a path-traced picture is made of.
struct Traced {
    Memory& memory;
    const GpuLevel& level; // with rays: buildRays, for paths
    const GpuPaths& paths; // of the same level
    Tracing tracing = Tracing::kernel;
};

// The mean of all samples, scene-linear, RGBA32F: perFrame more than before, up to parameters.samples; from the start where it is another
// picture than before.
Texture truth(Graph& graph, const Traced& traced, const Picture& picture, TracedSamples& samples, const TruthParameters& parameters);

// Two pictures of one size on either side of a line, `share` of the width from the left; RGBA32F.
Texture wipe(Graph& graph, const Texture& left, const Texture& right, float share);
}
