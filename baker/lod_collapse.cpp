#include "baker/lod_collapse.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace afterglow
{
namespace
{
constexpr double kStraight = 1e-6;   // of the diagonal: borders and seams are straight within it
constexpr double kUvRounding = 2e-6; // what float uv stray from a line that was meant straight
constexpr double kTurn = 0.5;        // cosine by which a face may turn in one collapse
constexpr double kNeedle = 1e-3;     // twice the area over the square of the longest side, below which a face is too thin
constexpr double kShort = 1e-7;      // of the squared length: among equals, the shorter edge goes first

dvec3 position(const HalfEdges& mesh, HalfEdges::VertexHandle v)
{
    const auto& p = mesh.point(v);
    return {p[0], p[1], p[2]};
}

double twice(const vec2& a, const vec2& b, const vec2& c)
{
    dvec2 u = dvec2(b) - dvec2(a), v = dvec2(c) - dvec2(a);
    return u.x * v.y - u.y * v.x;
}

// How far b strays from the way from a to c; infinite when it does not lie between them.
template <typename V>
double straying(const V& a, const V& b, const V& c)
{
    V way = c - a, to = b - a;
    double length2 = dot(way, way);
    if (!(length2 > 0.0)) return dot(to, to) > 0.0 ? std::numeric_limits<double>::infinity() : 0.0;
    double t = dot(to, way) / length2;
    return t >= 0.0 && t <= 1.0 ? length(to - t * way) : std::numeric_limits<double>::infinity();
}

// Vertices that agree in everything a collapse must keep are one wedge: the first of them.
std::vector<uint> canonical(std::span<const Vertex> vertices)
{
    auto key = [&](uint v) {
        const Vertex& x = vertices[v];
        return std::array{x.position.x,
                          x.position.y,
                          x.position.z,
                          x.normal.x,
                          x.normal.y,
                          x.normal.z,
                          x.uv0.x,
                          x.uv0.y,
                          x.uv1.x,
                          x.uv1.y,
                          float(x.color & 0xffffu),
                          float(x.color >> 16)};
    };
    std::vector<uint> order(vertices.size()), result(vertices.size());
    for (uint v = 0; v < order.size(); ++v) order[v] = v;
    std::sort(order.begin(), order.end(), [&](uint a, uint b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
    for (std::size_t i = 0; i < order.size(); ++i)
        result[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? result[order[i - 1]] : order[i];
    return result;
}
}

Collapses::Collapses(const DecimationInput& input)
    : vertices_(input.vertices), maxError_(input.maxError), uvDrift_(max(input.uvDrift, kUvRounding))
{
    std::vector<vec3> keys;
    std::vector<dvec3> positions;
    dvec3 lower(1e300), upper(-1e300);
    for (const Vertex& v : vertices_) {
        keys.push_back(v.position);
        positions.push_back(dvec3(v.position));
        lower = min(lower, positions.back()), upper = max(upper, positions.back());
    }
    diagonal_ = length(upper - lower);
    Weld welded = weld(keys, input.indices);
    point_ = welded.point;
    sheets_ = halfEdges(welded, positions, input.indices);

    std::vector<uint> one = canonical(vertices_);
    for (std::size_t i = 0; i + 2 < input.indices.size(); i += 3)
        wedges_.push_back({one[input.indices[i]], one[input.indices[i + 1]], one[input.indices[i + 2]]});

    // A point stays where another primitive holds it too, and where sheets meet with their borders and do not know of each other.
    std::vector<int> sheetsAt(welded.points);
    std::vector<bool> locked(welded.points);
    for (uint point : sheets_.point) ++sheetsAt[point];
    for (uint v = 0; v < vertices_.size(); ++v)
        if (input.locked[v]) locked[point_[v]] = true;

    HalfEdges& mesh = sheets_.mesh;
    quadrics_.resize(mesh.n_vertices());
    creases_.resize(mesh.n_vertices());
    drift_.resize(mesh.n_vertices());
    for (Node v : mesh.vertices()) {
        uint point = sheets_.point[std::size_t(v.idx())];
        int& creases = creases_[std::size_t(v.idx())];
        for (Edge edge : mesh.voh_range(v)) creases += crease(edge);
        mesh.status(v).set_locked(locked[point] || (sheetsAt[point] > 1 && creases > 0));
    }
    for (Face face : mesh.faces()) {
        dvec3 p[3];
        int i = 0;
        for (Node v : mesh.fv_range(face)) p[i++] = position(mesh, v);
        Quadric q = triangleQuadric(p[0], p[1], p[2]);
        for (Node v : mesh.fv_range(face)) quadrics_[std::size_t(v.idx())] = quadrics_[std::size_t(v.idx())] + q;
    }
}

uint Collapses::wedge(Face face, Node node) const
{
    uint point = sheets_.point[std::size_t(node.idx())];
    for (uint w : wedges_[std::size_t(face.idx())])
        if (point_[w] == point) return w;
    return ~0u;
}

// A border, or a seam: the faces on its two sides disagree about one of its ends.
bool Collapses::crease(Edge edge) const
{
    const HalfEdges& mesh = sheets_.mesh;
    Face left = mesh.face_handle(edge), right = mesh.opposite_face_handle(edge);
    if (!left.is_valid() || !right.is_valid()) return true;
    Node a = mesh.from_vertex_handle(edge), b = mesh.to_vertex_handle(edge);
    return wedge(left, a) != wedge(right, a) || wedge(left, b) != wedge(right, b);
}

std::optional<Collapses::Heirs> Collapses::heirs(Edge edge) const
{
    const HalfEdges& mesh = sheets_.mesh;
    Node a = mesh.from_vertex_handle(edge), b = mesh.to_vertex_handle(edge);
    Face left = mesh.face_handle(edge), right = mesh.opposite_face_handle(edge);
    if (!left.is_valid()) left = right;
    if (!right.is_valid()) right = left;
    Heirs heirs{{wedge(left, a), wedge(right, a)}, {wedge(left, b), wedge(right, b)}};
    if (heirs.from[0] == heirs.from[1] && heirs.to[0] != heirs.to[1]) return {};
    for (Face face : mesh.vf_range(a)) {
        uint w = wedge(face, a);
        if (w != heirs.from[0] && w != heirs.from[1]) return {};
    }
    return heirs;
}

// Of the two creases at the start of the edge, the one that is not the edge.
Collapses::Edge Collapses::otherCrease(Edge edge) const
{
    const HalfEdges& mesh = sheets_.mesh;
    for (Edge e : mesh.voh_range(mesh.from_vertex_handle(edge)))
        if (e != edge && crease(e)) return e;
    return Edge();
}

// How far the crease through the start strays in uv, all told, when it goes straight to the end; nothing when it is not one crease that
// does, or when it is a border and bends in space.
std::optional<double> Collapses::drift(Edge edge) const
{
    const HalfEdges& mesh = sheets_.mesh;
    Edge other = crease(edge) ? otherCrease(edge) : Edge();
    if (!other.is_valid()) return {};
    Node a = mesh.from_vertex_handle(edge), b = mesh.to_vertex_handle(edge), c = mesh.to_vertex_handle(other);
    // Left of one is right of the other: the two run in opposite directions.
    Face sides[2][2] = {{mesh.face_handle(edge), mesh.opposite_face_handle(other)},
                        {mesh.opposite_face_handle(edge), mesh.face_handle(other)}};
    double largest = 0.0;
    for (auto& [along, back] : sides) {
        if (along.is_valid() != back.is_valid()) return {};
        if (!along.is_valid()) {
            if (straying(position(mesh, b), position(mesh, a), position(mesh, c)) > kStraight * diagonal_) return {};
            continue;
        }
        if (wedge(along, a) != wedge(back, a)) return {};
        const Vertex &from = vertices_[wedge(along, b)], &at = vertices_[wedge(along, a)], &to = vertices_[wedge(back, c)];
        for (vec2 Vertex::*uv : {&Vertex::uv0, &Vertex::uv1})
            largest = max(largest, straying(dvec2(from.*uv), dvec2(at.*uv), dvec2(to.*uv)));
    }
    double total = drift_[std::size_t(a.idx())] + (largest > kUvRounding ? largest : 0.0);
    return total <= uvDrift_ ? std::optional(total) : std::nullopt;
}

// Some face that stays would turn too far, become a needle, or change its sense on a texture or lightmap.
bool Collapses::turnsOver(Edge edge, const Heirs& heirs) const
{
    const HalfEdges& mesh = sheets_.mesh;
    Node a = mesh.from_vertex_handle(edge), b = mesh.to_vertex_handle(edge);
    Face left = mesh.face_handle(edge), right = mesh.opposite_face_handle(edge);
    dvec3 start = position(mesh, a), end = position(mesh, b);
    for (Edge e : mesh.voh_range(a)) {
        Face face = mesh.face_handle(e);
        if (!face.is_valid() || face == left || face == right) continue;
        Node u = mesh.to_vertex_handle(e), v = mesh.to_vertex_handle(mesh.next_halfedge_handle(e));
        dvec3 p = position(mesh, u), q = position(mesh, v);
        dvec3 was = cross(p - start, q - start), is = cross(p - end, q - end);
        if (dot(was, is) < kTurn * length(was) * length(is)) return true;
        double longest = max(max(dot(p - end, p - end), dot(q - end, q - end)), dot(q - p, q - p));
        if (length(is) < kNeedle * longest && length(is) < length(was)) return true;

        uint w = wedge(face, a), heir = w == heirs.from[0] ? heirs.to[0] : heirs.to[1], wu = wedge(face, u), wv = wedge(face, v);
        for (vec2 Vertex::*uv : {&Vertex::uv0, &Vertex::uv1}) {
            double sense = twice(vertices_[w].*uv, vertices_[wu].*uv, vertices_[wv].*uv);
            if (sense != 0.0 && sense * twice(vertices_[heir].*uv, vertices_[wu].*uv, vertices_[wv].*uv) <= 0.0) return true;
        }
    }
    return false;
}

std::optional<double> Collapses::cost(Edge edge) const
{
    const HalfEdges& mesh = sheets_.mesh;
    Node a = mesh.from_vertex_handle(edge), b = mesh.to_vertex_handle(edge);
    Quadric sum = quadrics_[std::size_t(a.idx())] + quadrics_[std::size_t(b.idx())];
    dvec3 end = position(mesh, b), way = end - position(mesh, a);
    double error = sum(end);
    if (error > maxError_ * maxError_ * sum.area) return {};
    int creases = creases_[std::size_t(a.idx())];
    if (creases != 0 && (creases != 2 || !drift(edge))) return {};
    std::optional<Heirs> heir = heirs(edge);
    if (!heir || turnsOver(edge, *heir)) return {};
    return error + kShort * dot(way, way) * sum.area;
}

void Collapses::before(Edge edge)
{
    const HalfEdges& mesh = sheets_.mesh;
    Node a = mesh.from_vertex_handle(edge), b = mesh.to_vertex_handle(edge);
    if (creases_[std::size_t(a.idx())] == 2) {
        double strayed = drift(edge).value_or(0.0);
        for (Node end : {b, mesh.to_vertex_handle(otherCrease(edge))})
            drift_[std::size_t(end.idx())] = max(drift_[std::size_t(end.idx())], strayed);
    }
    std::optional<Heirs> heir = heirs(edge);
    Face left = mesh.face_handle(edge), right = mesh.opposite_face_handle(edge);
    for (Face face : mesh.vf_range(a)) {
        if (face == left || face == right) continue;
        uint w = wedge(face, a);
        for (uint& mine : wedges_[std::size_t(face.idx())])
            if (mine == w) mine = w == heir->from[0] ? heir->to[0] : heir->to[1];
    }
    quadrics_[std::size_t(b.idx())] = quadrics_[std::size_t(a.idx())] + quadrics_[std::size_t(b.idx())];
}

double Collapses::scale() const { return diagonal_ > 0.0 ? diagonal_ * diagonal_ * diagonal_ * diagonal_ * 1e-12 : 1.0; }

std::vector<uint> Collapses::indices() const
{
    std::vector<uint> result;
    for (std::size_t f = 0; f < wedges_.size(); ++f)
        if (!sheets_.mesh.status(Face(int(f))).deleted()) result.insert(result.end(), wedges_[f].begin(), wedges_[f].end());
    return result;
}
}
