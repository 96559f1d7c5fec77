// A reflection probe as a cubemap whose mips are its roughnesses (shaders/reflection.h).
#pragma once
#include "engine/baked/baked.hpp"
#include "engine/baked/ktx2.hpp"

namespace afterglow
{
// rgba16f, or rgba32f where a radiance is beyond half's range. Keys: ag_name, ag_position, ag_box (lower, upper), in the level's own
// coordinates; `origin` is the scene's.
Ktx2 reflectionTexture(const ReflectionProbe& probe, dvec3 origin = dvec3(0.0));

// Throws Error when the texture is not a reflection probe.
ReflectionProbe readReflection(const Ktx2& texture, const std::string& what, dvec3 origin = dvec3(0.0));
}
