// Gives every static object a place in the lightmap pages: charts that lie nearly flat, padded rectangles, pages of texels.
// Answers "where on which page is this point of this surface?"; engine/baked keeps the answer, the lightmap stage fills the pages.
#pragma once
#include "engine/baked/baked.hpp"
#include "engine/core/progress.hpp"
#include "engine/scene/scene.hpp"
#include <vector>

namespace afterglow
{
using Pieces = std::vector<std::vector<uint>>; // per mesh, per triangle: which piece of it; a mesh without any is one

struct AtlasOptions {
    float texelsPerMetre = 16.0f; // along world-space lengths; an object's own wins
    int pageSize = 1024;          // texels, edge of a page; a page shrinks to what it needs, a multiple of 8 (the lightmap's tile)
    int padding = 2;              // texels kept free between charts, so that no bilinear footprint touches two
    int maxPageSize = 4096;       // texels, edge of a page that one large chart may ask for
    Pieces pieces;                // that share no chart
    int pages = 0;                // of pageSize, filled: densities are scaled by one factor until they are. 0: as many as the densities ask
};

struct AtlasReport {
    float utilisation = 0.0f; // area of the charts / area of the pages
    int charts = 0;           // rectangles placed: a shared mesh counts once per object
    int pages = 0;
    float stretch = 1.0f; // Sander's L2 of texels over metres, each object for itself, area-weighted, 1: isometric (Sander et al. 2001)
    float texelsPerMetre = 0.0f; // honoured, area-weighted median
};

struct Atlas {
    std::vector<LightmapPlace> places; // one per scene.objects; page -1: not static, or nothing to light
    std::vector<ivec2> pageSizes;      // texels
    AtlasReport report;
};

// Rewrites the vertices and indices of the scene (vertices on the borders of charts are split) and their uv1. A mesh used by one object
// gets the page's uv (scale 1, offset 0); a mesh used by several gets uv in its own rectangle and one such rectangle per object.
// Triangles keep their order. What had to give way (a density that asks for too many pages) is told in scene.warnings.
// Advances by the triangles of all meshes.
Atlas makeAtlas(Scene& scene, const AtlasOptions& options, const Advance& advance = unheard);
}
