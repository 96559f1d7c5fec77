// Cubemaps as hardware looks them up: bilinear, across the edges of faces, linear between mips.
#pragma once
#include "engine/baked/baked.hpp"
#include "shaders/reflection.h"
#include <span>

namespace afterglow
{
// Radiance from `direction` in a cubemap with faces of size * size texels. Where three faces meet, the corner that no texel has is the mean
// of the three about it, as Vulkan says.
vec3 cubeRadiance(const std::vector<vec3>& faces, int size, vec3 direction);

// The same blurred as by a GGX lobe of that perceptual roughness, from a probe's mips.
vec3 cubeRadiance(const ReflectionProbe& probe, vec3 direction, float roughness);

shared::ReflectionBox boxOf(const ReflectionProbe& probe);

// What a point mirrors from direction r: radiance, blurred by that roughness; what no box covers is `fallback`. As
// engine/effects/indirect.glsl has it.
vec3 reflectedRadiance(std::span<const ReflectionProbe> probes, vec3 position, vec3 r, float roughness, vec3 fallback);
}
