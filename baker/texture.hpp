// Textures read on the CPU: bilinear, with the file's wrap modes, decoded to linear. Truth and baker filter by many samples, not by mips.
#pragma once
#include "engine/scene/scene.hpp"

namespace afterglow
{
// The texel's colour where `ref` points at uv (two sets); white when ref has no texture. rgb linear.
vec4 sampleTexture(const Scene& scene, const TextureRef& ref, vec2 uv0, vec2 uv1);
}
