#include "baker/half_edges.hpp"

namespace afterglow
{
HalfEdgeMesh halfEdges(const Weld& weld, std::span<const dvec3> positions, std::span<const uint> indices)
{
    HalfEdgeMesh result;
    HalfEdges& mesh = result.mesh;
    mesh.reserve(weld.pointOfVertex.size(), indices.size() / 2, indices.size() / 3);
    result.point = weld.pointOfVertex;

    std::vector<uint> example(weld.points); // any vertex at the point
    for (uint v = 0; v < weld.point.size(); ++v) example[weld.point[v]] = v;
    auto place = [&](uint point) {
        const dvec3& p = positions[example[point]];
        return mesh.add_vertex({p.x, p.y, p.z});
    };
    for (uint point : weld.pointOfVertex) place(point);

    auto accepts = [&](const HalfEdges::VertexHandle* v) {
        for (int i = 0; i < 3; ++i) {
            if (v[i] == v[(i + 1) % 3] || !mesh.is_boundary(v[i])) return false;
            HalfEdges::HalfedgeHandle edge = mesh.find_halfedge(v[i], v[(i + 1) % 3]);
            if (edge.is_valid() && !mesh.is_boundary(edge)) return false;
        }
        return true;
    };
    for (std::size_t corner = 0; corner < indices.size(); corner += 3) {
        HalfEdges::VertexHandle v[3];
        bool sound = true;
        for (int i = 0; i < 3; ++i) {
            v[i] = HalfEdges::VertexHandle(int(weld.vertex[corner + i]));
            sound = sound && weld.point[indices[corner + i]] != weld.point[indices[corner + (i + 1) % 3]];
        }
        if (sound && accepts(v) && mesh.add_face(v, 3).is_valid()) continue;
        ++result.loose;
        for (int i = 0; i < 3; ++i) {
            uint point = weld.point[indices[corner + i]];
            v[i] = place(point);
            result.point.push_back(point);
        }
        mesh.add_face(v, 3);
    }
    return result;
}
}
