// A reflection probe as a cubemap whose mips are its roughnesses (shaders/reflection.h).
#pragma once
#include "engine/baked/baked.hpp"
#include "engine/baked/ktx2.hpp"

namespace afterglow
{
// rgba16f, or rgba32f where a radiance is beyond half's range. Keys: ag_name, ag_position, ag_box (lower, upper).
Ktx2 reflectionTexture(const ReflectionProbe& probe);

// Throws Error when the texture is not a reflection probe.
ReflectionProbe readReflection(const Ktx2& texture, const std::string& what);
}
