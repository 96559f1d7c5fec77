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
    double asked = 0.0;                // texels per metre, by the user that gets the fewest
    std::vector<double> scales;        // per user: its texels over the mesh's, along an edge; 1 or more
    Packing own;                       // of the charts in the mesh's own rectangle, when several objects use it
    std::vector<Footprint> rectangles; // per user, then: its place on a page, as large as its density asks

    bool shared() const { return objects.size() > 1; }
};

// Cuts every mesh into flat shapes. `densities`: texels per metre of world, per object of the scene; `pieces`: of its meshes, which share no chart.
std::vector<UnwrappedMesh> unwrapMeshes(Scene& scene, const std::vector<double>& densities, const Pieces& pieces, const PageLimits& limits,
                                        const Advance& advance);

// At `factor` times the density that is asked. False: the mesh, or a chart of it, is too large for a page.
bool setOnTexels(UnwrappedMesh& mesh, double factor, int padding, const PageLimits& limits);

// At the density that is asked, or the next lower one that fits a page; scene.warnings says so.
void setOnTexels(std::vector<UnwrappedMesh>& meshes, Scene& scene, int padding, const PageLimits& limits);
}
