// Inside of the truth: what all of its organisations are given, and the one of small kernels.
#pragma once
#include "engine/effects/truth/truth.hpp"

namespace afterglow
{
struct PathTracing {
    Graph& graph;
    const Traced& traced;
    const TracedSamples& samples;
    Buffer frame;    // samples.of
    TruthPush added; // samples of this frame
};

// Bindings 0 to 9 and the constants of whatever includes tracer.glsl and sums.glsl.
Pass& give(Pass& pass, const PathTracing& to);

// The mean of all samples.
Texture traceWaves(const PathTracing& paths);
}
