// Judges an atlas from the finished scene alone: what a lookup on each page may touch, and whose it is.
#pragma once
#include "baker/atlas.hpp"
#include <array>
#include <map>
#include <numeric>
#include <tuple>

namespace afterglow
{
struct AtlasAudit {
    int sharedTexels = 0; // within a texel of two charts: one bilinear lookup could mix them
    int folded = 0;       // texel centres inside two triangles
    int outside = 0;      // corners off their page
    int flipped = 0;      // triangles that run clockwise on the page
    int steep = 0;        // triangles stretched more than 2.5 times as much along one direction as along another, larger than a texel
    int unlit = 0;        // charts without a texel's centre of their own
    int charts = 0;       // as found: triangles joined by corners of one position and uv
    double area = 0;      // m2 of triangles that have a place
    std::vector<Image8> pictures; // one colour per chart, brighter where a texel's centre is covered
};

namespace audit
{
struct Placed {
    dvec3 p[3]; // world, m
    dvec2 t[3]; // page, texels
    int page;
    uint chart;
};

inline double twiceArea(const dvec2* t) { return (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[1].y - t[0].y) * (t[2].x - t[0].x); }

// Separating axes of the open square about `centre` and the triangle.
inline bool squareMeets(const dvec2* t, dvec2 centre, double half)
{
    for (int axis = 0; axis < 2; ++axis) {
        double low = min(min(t[0][axis], t[1][axis]), t[2][axis]), high = max(max(t[0][axis], t[1][axis]), t[2][axis]);
        if (low >= centre[axis] + half - 1e-4 || high <= centre[axis] - half + 1e-4) return false;
    }
    double side = twiceArea(t) < 0 ? -1 : 1;
    for (int i = 0; i < 3; ++i) {
        dvec2 edge = t[(i + 1) % 3] - t[i], inward = side * dvec2(-edge.y, edge.x);
        if (dot(inward, centre - t[i]) + half * (std::abs(inward.x) + std::abs(inward.y)) <= 1e-4 * length(edge)) return false;
    }
    return true;
}

// `inset` texels from every side; negative: a little outside counts as well.
inline bool inside(const dvec2* t, dvec2 p, double inset)
{
    for (int i = 0; i < 3; ++i) {
        dvec2 edge = t[(i + 1) % 3] - t[i], to = p - t[i];
        if (edge.x * to.y - edge.y * to.x <= inset * length(edge)) return false;
    }
    return true;
}

inline std::vector<Placed> placed(const Scene& scene, const Atlas& atlas, int& charts)
{
    std::vector<Placed> result;
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        const LightmapPlace& place = atlas.places[o];
        if (place.page < 0) continue;
        std::vector<uint> parent;
        std::map<std::array<float, 5>, uint> first; // the first triangle of this object with the corner
        auto root = [&](uint i) {
            while (parent[i] != i) i = parent[i];
            return i;
        };
        std::size_t begin = result.size();
        for (const Primitive& p : scene.meshes[scene.objects[o].mesh].primitives)
            for (uint i = 0; i + 2 < p.indexCount; i += 3) {
                Placed triangle{{}, {}, place.page, 0};
                parent.push_back(uint(parent.size()));
                for (uint k = 0; k < 3; ++k) {
                    const Vertex& v = scene.vertices[p.firstVertex + scene.indices[p.firstIndex + i + k]];
                    triangle.p[k] = dvec3(scene.objects[o].toWorld * dvec4(dvec3(v.position), 1.0));
                    triangle.t[k] =
                        (dvec2(v.uv1) * dvec2(place.scale) + dvec2(place.offset)) * dvec2(atlas.pageSizes[std::size_t(place.page)]);
                    auto [entry, isNew] =
                        first.try_emplace(std::array{v.position.x, v.position.y, v.position.z, v.uv1.x, v.uv1.y}, uint(parent.size() - 1));
                    uint a = root(entry->second), b = root(uint(parent.size() - 1));
                    parent[max(a, b)] = min(a, b);
                }
                result.push_back(triangle);
            }
        std::map<uint, uint> ids;
        for (uint i = 0; i < parent.size(); ++i) {
            uint id = ids.try_emplace(root(i), uint(charts + int(ids.size()))).first->second;
            result[begin + i].chart = id;
        }
        charts += int(ids.size());
    }
    return result;
}

inline bool steep(const Placed& s)
{
    dvec2 a = s.t[1] - s.t[0], b = s.t[2] - s.t[0];
    dvec3 e = s.p[1] - s.p[0], f = s.p[2] - s.p[0];
    double twice = twiceArea(s.t);
    if (std::abs(twice) < 2.0) return false;
    dvec3 u = (e * b.y - f * a.y) / twice, v = (f * a.x - e * b.x) / twice;
    double sum = dot(u, u) + dot(v, v), product = length(cross(u, v)), root = std::sqrt(max(sum * sum - 4 * product * product, 0.0));
    return (sum + root) > 2.5 * 2.5 * (sum - root);
}
}

inline AtlasAudit auditAtlas(const Scene& scene, const Atlas& atlas)
{
    AtlasAudit result;
    std::vector<audit::Placed> triangles = audit::placed(scene, atlas, result.charts);
    std::vector<bool> lit(std::size_t(result.charts), false), real(std::size_t(result.charts), false);
    for (std::size_t page = 0; page < atlas.pageSizes.size(); ++page) {
        ivec2 size = atlas.pageSizes[page];
        std::vector<uint> owner(std::size_t(size.x) * size.y, ~0u), covered(owner);
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            const audit::Placed& s = triangles[i];
            if (s.page != int(page)) continue;
            double surface = length(cross(s.p[1] - s.p[0], s.p[2] - s.p[0])) / 2;
            result.area += surface;
            dvec2 lower = min(min(s.t[0], s.t[1]), s.t[2]), upper = max(max(s.t[0], s.t[1]), s.t[2]);
            result.outside += lower.x < 0 || lower.y < 0 || upper.x > size.x || upper.y > size.y;
            if (std::abs(audit::twiceArea(s.t)) < 1e-6) continue;
            real[s.chart] = true;
            result.flipped += audit::twiceArea(s.t) < 0;
            result.steep += audit::steep(s);
            ivec2 from = max(ivec2(floor(lower)) - 2, ivec2(0)), to = min(ivec2(ceil(upper)) + 2, size);
            for (int y = from.y; y < to.y; ++y)
                for (int x = from.x; x < to.x; ++x) {
                    dvec2 centre(x + 0.5, y + 0.5);
                    std::size_t texel = std::size_t(y) * size.x + x;
                    if (audit::squareMeets(s.t, centre, 1.0)) {
                        if (owner[texel] != ~0u && owner[texel] != s.chart) ++result.sharedTexels;
                        owner[texel] = s.chart;
                    }
                    if (audit::inside(s.t, centre, 1e-3)) {
                        result.folded += covered[texel] != ~0u;
                        covered[texel] = s.chart;
                    }
                    if (audit::inside(s.t, centre, -1e-5)) lit[s.chart] = true;
                }
        }
        Image8 picture{size.x, size.y, 4, std::vector<std::uint8_t>(owner.size() * 4, 0)};
        for (std::size_t t = 0; t < owner.size(); ++t) {
            uint hash = (owner[t] + 1) * 2654435761u;
            for (int c = 0; c < 3; ++c)
                picture.pixels[4 * t + std::size_t(c)] =
                    owner[t] == ~0u ? 0 : std::uint8_t((64 + ((hash >> (8 * c + 8)) & 127)) * (covered[t] == ~0u ? 1 : 4) / 4 * 1);
            if (owner[t] != ~0u && covered[t] == ~0u)
                for (int c = 0; c < 3; ++c) picture.pixels[4 * t + std::size_t(c)] /= 3;
            picture.pixels[4 * t + 3] = 255;
        }
        result.pictures.push_back(std::move(picture));
    }
    for (std::size_t c = 0; c < lit.size(); ++c) result.unlit += real[c] && !lit[c];
    return result;
}
}
