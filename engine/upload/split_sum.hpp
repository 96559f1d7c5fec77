// The table that goes with prefiltered reflections: what a GGX lobe reflects of a constant surrounding, apart by Fresnel's two terms.
// This work is based on: Karis 2013, "Real Shading in Unreal Engine 4".
#pragma once
#include "engine/gpu/gpu.hpp"
#include "shaders/glsl.h"

namespace afterglow
{
// Directional albedo for Schlick's Fresnel is f0 * scale + bias, n.v = mu. Deterministic: 256 points of an R2 sequence.
shared::vec2 splitSum(float mu, float roughness);

// As shaders/gpu_baked.h says it is looked up.
GpuImage uploadSplitSum(Gpu& gpu);
}
