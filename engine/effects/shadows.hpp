// The handles by which passes ask for shadows: maps (shaders/shadow_map.glsl), or what was traced. All empty: nothing casts a shadow.
#pragma once
#include "engine/graph/graph.hpp"

namespace afterglow
{
struct Shadows {
    Texture atlas;
    Buffer views;              // ShadowView
    Buffer first;              // by light: its first view, -1: none
    std::uint32_t sunMaps = 0; // of each sun: cascades, then its map of the level; 0: there is no map
    Texture traced;            // by ray query, for the surface at each pixel: share of four lights a layer; absent: the maps say
};
}
