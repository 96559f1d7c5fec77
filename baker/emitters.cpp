#include "baker/emitters.hpp"
#include "shaders/color.h"
#include "shaders/path.h"
#include "shaders/sampling.h"
#include <algorithm>

namespace afterglow
{
// Mean emission over a triangle, from a few points: it only steers the choice, so it need not be exact, but never 0 where light leaves.
static float meanEmission(const World& world, uint triangle)
{
    const Material& material = world.materialOf(triangle);
    float factor = luminance(material.emission);
    if (material.emissiveTexture.texture < 0) return factor;
    float sum = 0.0f;
    for (vec2 b :
         {vec2(1.0f / 3.0f), vec2(0.1f, 0.1f), vec2(0.8f, 0.1f), vec2(0.1f, 0.8f), vec2(0.45f, 0.1f), vec2(0.1f, 0.45f), vec2(0.45f)})
        sum += luminance(world.emissionAt(triangle, b));
    return std::max(sum / 7.0f, 0.02f * factor);
}

static vec3 areaVector(const World& world, uint triangle)
{
    const World::Triangle& t = world.triangles()[triangle];
    const std::vector<Vertex>& v = world.vertices();
    vec3 origin = v[t.vertex[0]].position;
    return 0.5f * cross(v[t.vertex[1]].position - origin, v[t.vertex[2]].position - origin);
}

Emitters::Emitters(const World& world) : world_(world)
{
    std::vector<double> power;
    double total = 0.0;
    for (uint i = 0; i < world.triangles().size(); i++) {
        const Material& material = world.materialOf(i);
        if (!(largestOf(material.emission) > 0.0f)) continue;
        double mine = double(meanEmission(world, i)) * double(length(areaVector(world, i)));
        if (!(mine > 0.0)) continue;
        triangles_.push_back(i);
        power.push_back(mine);
        total += mine;
    }
    if (triangles_.empty()) return;
    density_.assign(world.triangles().size(), 0.0f);
    double sum = 0.0;
    for (std::size_t i = 0; i < triangles_.size(); i++) {
        sum += power[i];
        cumulative_.push_back(float(sum / total));
        density_[triangles_[i]] = float(power[i] / total / double(length(areaVector(world, triangles_[i]))));
    }
    cumulative_.back() = 1.0f;
}

LightSample Emitters::sample(vec3 from, float choice, vec2 u) const
{
    LightSample light = noLight();
    if (cumulative_.empty()) return light;
    std::size_t i = std::size_t(std::upper_bound(cumulative_.begin(), cumulative_.end(), choice) - cumulative_.begin());
    uint triangle = triangles_[std::min(i, triangles_.size() - 1)];
    const World::Triangle& t = world_.triangles()[triangle];
    const std::vector<Vertex>& v = world_.vertices();
    vec3 b = sampleTriangle(u);
    vec3 point = b.x * v[t.vertex[0]].position + b.y * v[t.vertex[1]].position + b.z * v[t.vertex[2]].position;
    vec3 offset = point - from;
    float squared = dot(offset, offset);
    if (!(squared > 0.0f)) return light;
    light.distance = sqrt(squared);
    light.direction = offset / light.distance;
    float cosine = -dot(normalize(areaVector(world_, triangle)), light.direction);
    if ((world_.materialOf(triangle).flags & kMaterialDoubleSided) != 0) cosine = abs(cosine);
    if (!(cosine > 0.0f)) return light;
    light.delta = 0;
    light.radiance = world_.emissionAt(triangle, vec2(b.y, b.z));
    light.pdf = density_[triangle] * squared / cosine;
    return light;
}

float Emitters::pdf(const Ray& ray, const Hit& hit, const Surface& surface) const
{
    if (density_.empty()) return 0.0f;
    float cosine = abs(dot(ray.direction, surface.geometricNormal));
    return cosine > 0.0f ? density_[hit.triangle] * hit.distance * hit.distance / cosine : 0.0f;
}
}
