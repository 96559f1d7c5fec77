// Where two charts of the lightmaps are one smooth surface: along the sides at which a mesh was cut into charts, and where meshes of a
// level meet edge to edge. Answers "which two lookups must agree?"; stitch.hpp makes them.
#pragma once
#include "baker/world.hpp"
#include "engine/baked/baked.hpp"

namespace afterglow
{
// A place on a page, in texels.
struct Lookup {
    uint page;
    vec2 at;
};

// A point of the level that two charts hold.
struct SeamPoint {
    vec3 position, normal; // world, m; unit shading normal
    Lookup side[2];
    vec3 into[2]; // m, half a texel from the point into the surface of each side
    float share;  // of the points of a texel's length: where many short sides make up one, each has less than a point's say
};

// Points all along where surfaces go on across the border of a chart: sides lie together, their shading normals are one, and none of them
// turns back over the other. Those of a crease are none.
std::vector<SeamPoint> seamPoints(const World& world, const std::vector<LightmapPlace>& places, const std::vector<ivec2>& pageSizes,
                                  int threads);
}
