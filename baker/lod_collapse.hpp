// The rules of a half-edge collapse: what it costs, and which are forbidden. What lies around a vertex is read from OpenMesh.
#pragma once
#include "baker/half_edges.hpp"
#include "baker/lod_decimate.hpp"
#include "baker/quadric.hpp"

namespace afterglow
{
// A wedge is a vertex of the primitive: a point with one set of attributes. The faces around a point hold one wedge where the surface is
// smooth, several where a seam passes.
using Wedges = std::array<uint, 3>;

class Collapses
{
public:
    explicit Collapses(const DecimationInput& input);

    // The cost of moving the start of the half-edge to its end (m4, of the sum of both quadrics); nothing when it is forbidden.
    std::optional<double> cost(HalfEdges::HalfedgeHandle edge) const;
    void before(HalfEdges::HalfedgeHandle edge); // the collapse: the wedges of the faces that stay follow

    double scale() const; // m4: of a large cost
    HalfEdges& mesh() { return sheets_.mesh; }
    std::vector<uint> indices() const; // of the faces that are left, in their order

private:
    using Node = HalfEdges::VertexHandle; // a point of the surface; `Vertex` is the level's
    using Edge = HalfEdges::HalfedgeHandle;
    using Face = HalfEdges::FaceHandle;

    // Which wedge of the end takes over from which of the start: one pair on each side of the edge.
    struct Heirs {
        uint from[2], to[2];
    };

    uint wedge(Face face, Node node) const;
    std::optional<Heirs> heirs(Edge edge) const;
    bool crease(Edge edge) const;
    std::optional<double> drift(Edge edge) const;
    Edge otherCrease(Edge edge) const;
    bool turnsOver(Edge edge, const Heirs& heirs) const;

    std::span<const Vertex> vertices_;
    std::vector<uint> point_; // per wedge
    HalfEdgeMesh sheets_;
    std::vector<Wedges> wedges_;    // per face
    std::vector<Quadric> quadrics_; // per node
    std::vector<int> creases_;      // per node: edges there that are borders or seams
    std::vector<double> drift_;     // per node: how far the seams there have strayed in uv
    double maxError_, uvDrift_;
    double diagonal_; // m
};
}
