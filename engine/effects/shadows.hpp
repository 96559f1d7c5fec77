// The handles by which passes look up shadow maps (shaders/shadow_map.glsl). All empty: nothing casts a shadow.
#pragma once
#include "engine/graph/graph.hpp"

namespace afterglow
{
struct Shadows {
    Texture atlas;
    Buffer views;              // ShadowView
    Buffer first;              // by light: its first view, -1: none
    std::uint32_t sunMaps = 0; // of each sun: cascades, then its map of the level; 0: nothing casts a shadow
};
}
