#include "baker/atlas_report.hpp"
#include <algorithm>
#include <cmath>

namespace afterglow
{
namespace
{
struct Texels {          // of one triangle
    double area = 0;     // texels
    double surface = 0;  // m2
    double stretch2 = 0; // mean of the squared singular values of texels -> metres
};

struct Sums { // of one object
    double texels = 0, surface = 0, stretch = 0;
};

// Calls with every triangle of every placed object: the object, its corners in the world and on its page.
template <typename Visit>
void visit(const Scene& scene, const std::vector<LightmapPlace>& places, const std::vector<ivec2>& sizes, Visit call)
{
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        const LightmapPlace& place = places[o];
        if (place.page < 0) continue;
        dmat3 toWorld(scene.objects[o].toWorld);
        for (const Primitive& p : scene.meshes[scene.objects[o].mesh].primitives)
            for (uint i = 0; i + 2 < p.indexCount; i += 3) {
                dvec3 point[3];
                dvec2 texel[3];
                for (uint k = 0; k < 3; ++k) {
                    const Vertex& v = scene.vertices[p.firstVertex + scene.indices[p.firstIndex + i + k]];
                    point[k] = toWorld * dvec3(v.position);
                    texel[k] = (dvec2(v.uv1) * dvec2(place.scale) + dvec2(place.offset)) * dvec2(sizes[std::size_t(place.page)]);
                }
                call(o, point, texel);
            }
    }
}

// Sander et al. 2001: with S(u, v) the point of the surface, (|S_u|^2 + |S_v|^2) / 2 is the mean of the squared singular values.
Texels measure(const dvec3* p, const dvec2* t)
{
    dvec2 a = t[1] - t[0], b = t[2] - t[0];
    dvec3 e = p[1] - p[0], f = p[2] - p[0];
    double twice = a.x * b.y - a.y * b.x;
    Texels result{std::abs(twice) / 2, length(cross(e, f)) / 2, 0.0};
    if (result.area < 1e-9) return result;
    dvec3 su = (e * b.y - f * a.y) / twice, sv = (f * a.x - e * b.x) / twice;
    result.stretch2 = (dot(su, su) + dot(sv, sv)) / 2;
    return result;
}
}

AtlasReport measureAtlas(const Scene& scene, const std::vector<LightmapPlace>& places, const std::vector<ivec2>& pageSizes, int charts)
{
    std::vector<Texels> triangles;
    std::vector<Sums> objects(scene.objects.size()); // each has a density of its own, which is no stretch
    visit(scene, places, pageSizes, [&](std::size_t object, const dvec3* p, const dvec2* t) {
        const Texels& texels = triangles.emplace_back(measure(p, t));
        if (texels.area < 1e-9) return;
        Sums& sums = objects[object];
        sums.texels += texels.area;
        sums.surface += texels.surface;
        sums.stretch += texels.stretch2 * texels.surface;
    });
    double texels = 0, surface = 0, stretch = 0, pages = 0;
    for (const Sums& sums : objects) {
        if (!(sums.surface > 0.0)) continue;
        texels += sums.texels;
        surface += sums.surface;
        stretch += sums.stretch * sums.texels / sums.surface;
    }
    for (const ivec2& size : pageSizes) pages += double(size.x) * size.y;

    AtlasReport report;
    report.charts = charts;
    report.pages = int(pageSizes.size());
    if (!(texels > 0.0) || !(surface > 0.0)) return report;
    report.utilisation = float(texels / pages);
    report.stretch = float(std::sqrt(stretch / surface));

    std::erase_if(triangles, [](const Texels& t) { return !(t.surface > 0.0); });
    std::sort(triangles.begin(), triangles.end(), [](const Texels& a, const Texels& b) { return a.area * b.surface < b.area * a.surface; });
    double half = 0;
    for (const Texels& t : triangles) {
        half += t.surface;
        report.texelsPerMetre = float(std::sqrt(t.area / t.surface));
        if (half >= surface / 2) break;
    }
    return report;
}
}
