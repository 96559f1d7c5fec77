// What a level's glossy surfaces mirror: rays that leave them by chance, and where each ends. Reflection probes are placed, and their boxes
// fitted, to answer these.
#pragma once
#include "baker/solids.hpp"

namespace afterglow
{
struct MirrorRay {
    vec3 from;      // just off the surface
    vec3 normal;    // geometric, on that side
    vec3 direction; // unit
    float distance; // m; kRayFar: it leaves the level
    float weight;   // of what the surface mirrors: how much of it, and how sharp
};

// `count` tries. Points lie even over the area, by what a surface mirrors at most; directions are cosine-distributed, as they are for an
// eye anywhere. For glossy objects that move, rays from anywhere in the open. Empty: the level has nothing glossy.
std::vector<MirrorRay> mirrorRays(const World& world, const Solids& solids, std::size_t count, uint seed);
}
