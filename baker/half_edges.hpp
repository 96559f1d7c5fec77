// The half-edge mesh of a welded triangle list, in OpenMesh: face i is triangle i. Included by the stages that walk it, nowhere else.
#pragma once
#include "baker/weld.hpp"
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

namespace afterglow
{
struct HalfEdgeTraits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    VertexAttributes(OpenMesh::Attributes::Status);
    EdgeAttributes(OpenMesh::Attributes::Status);
    FaceAttributes(OpenMesh::Attributes::Status);
    HalfedgeAttributes(OpenMesh::Attributes::None);
};
using HalfEdges = OpenMesh::TriMesh_ArrayKernelT<HalfEdgeTraits>;

struct HalfEdgeMesh {
    HalfEdges mesh;
    std::vector<uint> point; // per vertex of the mesh: its weld point
    int loose = 0;           // triangles that stand alone: degenerate, or refused by their neighbours
};

// Every triangle becomes a face: one that its neighbours refuse gets three vertices of its own.
HalfEdgeMesh halfEdges(const Weld& weld, std::span<const dvec3> positions, std::span<const uint> indices);
}
