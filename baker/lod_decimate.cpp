#include "baker/lod_decimate.hpp"
#include "baker/lod_collapse.hpp"
#include "engine/core/interrupt.hpp"
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>

namespace afterglow
{
namespace
{
// The decimater's one module: it prices a collapse and follows it.
template <typename MeshT>
class CollapseModule : public OpenMesh::Decimater::ModBaseT<MeshT>
{
public:
    DECIMATING_MODULE(CollapseModule, MeshT, Collapse);
    explicit CollapseModule(MeshT& mesh) : Base(mesh, /* binary= */ false) {}

    float collapse_priority(const CollapseInfo& info) override
    {
        stopIfInterrupted();
        std::optional<double> cost = collapses->cost(info.v0v1);
        return cost ? float(min(*cost / scale, 1e30)) : float(Base::ILLEGAL_COLLAPSE);
    }
    void preprocess_collapse(const CollapseInfo& info) override
    {
        collapses->before(info.v0v1);
        (*gone)(info.fl.is_valid() + info.fr.is_valid());
    }

    Collapses* collapses = nullptr;
    const Advance* gone = nullptr;
    double scale = 1; // m4: keeps the costs of small and of large meshes within float
};
}

std::vector<std::vector<uint>> decimate(const DecimationInput& input, const std::vector<std::size_t>& targets)
{
    Collapses collapses(input);
    HalfEdges& mesh = collapses.mesh();
    OpenMesh::Decimater::DecimaterT<HalfEdges> decimater(mesh);
    CollapseModule<HalfEdges>::Handle handle;
    decimater.add(handle);
    decimater.module(handle).collapses = &collapses;
    decimater.module(handle).gone = &input.gone;
    decimater.module(handle).scale = collapses.scale();
    decimater.initialize();

    std::vector<std::vector<uint>> levels;
    for (std::size_t target : targets) {
        // OpenMesh counts from all the faces there ever were.
        std::size_t left = collapses.indices().size() / 3, gone = mesh.n_faces() - left;
        if (target < left) decimater.decimate_to_faces(0, target + gone);
        levels.push_back(collapses.indices());
    }
    return levels;
}
}
