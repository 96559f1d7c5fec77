// Every mesh that static objects use, cut and laid flat at the density of the object that gets the fewest texels.
#pragma once
#include "baker/atlas.hpp"
#include "baker/atlas_flatten.hpp"
#include "baker/atlas_pages.hpp"

namespace afterglow
{
struct UnwrappedMesh {
    uint mesh = 0;
    Surface surface;
    std::vector<FlatChart> charts;
    std::vector<std::size_t> objects;  // its static users
    std::vector<double> scales;        // per user: its texels over the mesh's, along an edge; 1 or more
    Packing own;                       // of the charts in the mesh's own rectangle, when several objects use it
    std::vector<Footprint> rectangles; // per user, then: its place on a page, as large as its density asks

    bool shared() const { return objects.size() > 1; }
};

// `densities`: texels per metre of world, per object of the scene. An object that fits no page gets less, and scene.warnings says so.
std::vector<UnwrappedMesh> unwrapMeshes(Scene& scene, const std::vector<double>& densities, const AtlasOptions& options,
                                        const PageLimits& limits, const Advance& advance);
}
