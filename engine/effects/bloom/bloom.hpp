// Bloom: what the lens scatters of bright light, as far as the level says (ag_bloom).
#pragma once
#include "engine/effects/bloom/bloom.h"
#include "engine/effects/view.hpp"

namespace afterglow
{
// Scene-linear in and out, before exposure. All light of the picture stays in it.
Texture bloom(Graph& graph, const Texture& image, const BloomParameters& parameters);
}
