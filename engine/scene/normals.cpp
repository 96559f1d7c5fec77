#include "engine/scene/normals.hpp"
#include "shaders/frame.h"
#include <algorithm>
#include <cmath>

namespace afterglow
{
using namespace shared;

namespace
{
// The unit vector, or zero when there is none: NaN, infinite, or nothing left after rounding.
vec3 unit(dvec3 v)
{
    const double size = length(v);
    return size > 1e-290 && std::isfinite(size) ? vec3(v / size) : vec3(0.0f);
}

bool none(vec3 v) { return v == vec3(0.0f); }

// The triangle's normal, as long as twice its area.
dvec3 areaNormal(const std::vector<Vertex>& vertices, const uint* corner)
{
    const dvec3 a(vertices[corner[0]].position), b(vertices[corner[1]].position), c(vertices[corner[2]].position);
    return cross(b - a, c - a);
}

double angleBetween(dvec3 a, dvec3 b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

// A glTF image's v grows downwards and a normal map's green upwards, so the bitangent is -dP/dv, and the hand is +1 where the texture is
// not mirrored: where the corners turn clockwise in (u, v).
double uvArea(const Vertex& a, const Vertex& b, const Vertex& c)
{
    const dvec2 ab = dvec2(b.uv0) - dvec2(a.uv0), ac = dvec2(c.uv0) - dvec2(a.uv0);
    return ab.x * ac.y - ac.x * ab.y;
}

// Gives each vertex one hand: a corner of the other hand gets a copy of its vertex.
void splitMirrored(std::vector<Vertex>& vertices, std::vector<uint>& indices)
{
    constexpr uint kNone = ~0u;
    std::vector<uint> twin(vertices.size(), kNone);
    std::vector<float> hand(vertices.size(), 0.0f);
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const double area = uvArea(vertices[indices[i]], vertices[indices[i + 1]], vertices[indices[i + 2]]);
        if (area == 0.0) continue;
        const float own = area < 0.0 ? 1.0f : -1.0f;
        for (std::size_t corner = i; corner < i + 3; ++corner) {
            const uint v = indices[corner];
            if (hand[v] == 0.0f) {
                hand[v] = own;
                vertices[v].tangent.w = own;
            } else if (hand[v] != own) {
                if (twin[v] == kNone) {
                    twin[v] = uint(vertices.size());
                    vertices.push_back(vertices[v]);
                    vertices.back().tangent.w = own;
                }
                indices[corner] = twin[v];
            }
        }
    }
}
}

int completeNormals(std::vector<Vertex>& vertices, const std::vector<uint>& indices)
{
    std::vector<uint> broken;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        vertices[i].normal = unit(dvec3(vertices[i].normal));
        if (none(vertices[i].normal)) broken.push_back(uint(i));
    }
    if (broken.empty()) return 0;

    std::vector<dvec3> sum(vertices.size(), dvec3(0.0)), last(vertices.size(), dvec3(0.0));
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const dvec3 normal = areaNormal(vertices, &indices[i]);
        for (std::size_t corner = i; corner < i + 3; ++corner) {
            sum[indices[corner]] += normal;
            last[indices[corner]] = normal;
        }
    }
    for (uint i : broken) {
        vertices[i].normal = unit(sum[i]);
        if (none(vertices[i].normal)) vertices[i].normal = unit(last[i]); // opposite triangles cancelled
    }
    return int(broken.size());
}

void computeTangents(std::vector<Vertex>& vertices, std::vector<uint>& indices)
{
    splitMirrored(vertices, indices);
    std::vector<dvec3> sum(vertices.size(), dvec3(0.0));
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const Vertex &a = vertices[indices[i]], &b = vertices[indices[i + 1]], &c = vertices[indices[i + 2]];
        const double area = uvArea(a, b, c);
        if (area == 0.0) continue;
        const dvec3 corners[3] = {dvec3(a.position), dvec3(b.position), dvec3(c.position)};
        const dvec3 ab = corners[1] - corners[0], ac = corners[2] - corners[0];
        // dP/du of the plane through the triangle
        const dvec3 alongU = (ab * (double(c.uv0.y) - double(a.uv0.y)) - ac * (double(b.uv0.y) - double(a.uv0.y))) / area;
        for (int k = 0; k < 3; ++k) {
            Vertex& vertex = vertices[indices[i + k]];
            const dvec3 normal(vertex.normal), flat = alongU - normal * dot(normal, alongU);
            const double angle = angleBetween(corners[(k + 1) % 3] - corners[k], corners[(k + 2) % 3] - corners[k]);
            sum[indices[i + k]] += dvec3(unit(flat)) * angle;
        }
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i].tangent = vec4(unit(sum[i]), vertices[i].tangent.w);
}

int completeTangents(std::vector<Vertex>& vertices)
{
    int broken = 0;
    for (Vertex& vertex : vertices) {
        const dvec3 normal(vertex.normal), given(vec3(vertex.tangent));
        const dvec3 perpendicular = given - normal * dot(normal, given);
        // A tangent along the normal leaves nothing but rounding.
        const bool usable = length(perpendicular) > 1e-6 * length(given) && std::isfinite(length(given));
        vec3 tangent = usable ? unit(perpendicular) : vec3(0.0f);
        if (none(tangent)) {
            tangent = makeFrame(vertex.normal).tangent;
            ++broken;
        }
        vertex.tangent = vec4(tangent, vertex.tangent.w);
    }
    return broken;
}
}
