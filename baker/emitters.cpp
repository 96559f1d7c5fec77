#include "baker/emitters.hpp"
#include "shaders/color.h"
#include "shaders/path.h"
#include "shaders/sampling.h"
#include <algorithm>

namespace afterglow
{
static bool varies(const Material& m)
{
    return m.emissiveTexture.texture >= 0 || (m.flags & (kMaterialAlphaMask | kMaterialAlphaBlend)) != 0;
}

// Mean emission over a triangle, from a few points: it only steers the choice, so it need not be exact, but never 0 where light leaves.
static float meanEmission(const World& world, uint triangle)
{
    const Material& material = world.materialOf(triangle);
    float factor = luminance(material.emission);
    if (!varies(material)) return factor;
    float sum = 0.0f;
    for (vec2 b :
         {vec2(1.0f / 3.0f), vec2(0.1f, 0.1f), vec2(0.8f, 0.1f), vec2(0.1f, 0.8f), vec2(0.45f, 0.1f), vec2(0.1f, 0.45f), vec2(0.45f)})
        sum += luminance(world.emissionAt(triangle, b));
    return std::max(sum / 7.0f, 0.02f * factor);
}

Emitters::Emitters(const World& world) : world_(world)
{
    std::vector<double> power;
    double total = 0.0;
    for (uint i = 0; i < world.triangles().size(); i++) {
        const Material& material = world.materialOf(i);
        if (!(largestOf(material.emission) > 0.0f)) continue;
        const World::Triangle& t = world.triangles()[i];
        Emitter emitter;
        emitter.triangle = i;
        emitter.corner = world.vertices()[t.vertex[0]].position;
        emitter.edge1 = world.vertices()[t.vertex[1]].position - emitter.corner;
        emitter.edge2 = world.vertices()[t.vertex[2]].position - emitter.corner;
        emitter.normal = cross(emitter.edge1, emitter.edge2); // twice the area, until the densities are known
        emitter.emission = material.emission;
        emitter.varies = varies(material);
        emitter.bothSides = (material.flags & kMaterialDoubleSided) != 0;
        double mine = double(meanEmission(world, i)) * double(length(emitter.normal));
        if (!(mine > 0.0)) continue;
        emitters_.push_back(emitter);
        power.push_back(mine);
        total += mine;
    }
    if (emitters_.empty()) return;
    density_.assign(world.triangles().size(), 0.0f);
    double sum = 0.0;
    for (std::size_t i = 0; i < emitters_.size(); i++) {
        sum += power[i];
        cumulative_.push_back(float(sum / total));
        float area = 0.5f * length(emitters_[i].normal);
        emitters_[i].normal = normalize(emitters_[i].normal);
        emitters_[i].density = density_[emitters_[i].triangle] = float(power[i] / total / double(area));
    }
    cumulative_.back() = 1.0f;
    guide_.resize(emitters_.size());
    uint first = 0;
    for (std::size_t i = 0; i < guide_.size(); i++) {
        while (!(cumulative_[first] > float(i) / float(guide_.size()))) first++;
        guide_[i] = first;
    }
}

std::size_t Emitters::choose(float u) const
{
    std::size_t i = guide_[std::min(std::size_t(u * float(guide_.size())), guide_.size() - 1)];
    while (i > 0 && cumulative_[i - 1] > u) i--; // a product rounded up
    while (i + 1 < cumulative_.size() && !(cumulative_[i] > u)) i++;
    return i;
}

Emitters::Point Emitters::point(float choice, vec2 u) const
{
    const Emitter& emitter = emitters_[choose(choice)];
    vec3 b = sampleTriangle(u);
    return {emitter.corner + b.y * emitter.edge1 + b.z * emitter.edge2, emitter.normal};
}

LightSample Emitters::sample(vec3 from, float choice, vec2 u) const
{
    LightSample light = noLight();
    if (cumulative_.empty()) return light;
    const Emitter& emitter = emitters_[choose(choice)];
    vec3 b = sampleTriangle(u);
    vec3 offset = emitter.corner + b.y * emitter.edge1 + b.z * emitter.edge2 - from;
    float squared = dot(offset, offset);
    if (!(squared > 0.0f)) return light;
    light.distance = sqrt(squared);
    light.direction = offset / light.distance;
    float cosine = -dot(emitter.normal, light.direction);
    if (emitter.bothSides) cosine = abs(cosine);
    if (!(cosine > 0.0f)) return light;
    light.delta = 0;
    light.radiance = emitter.varies ? world_.emissionAt(emitter.triangle, vec2(b.y, b.z)) : emitter.emission;
    light.pdf = emitter.density * squared / cosine;
    return light;
}

float Emitters::pdf(const Ray& ray, const Hit& hit, const Surface& surface) const
{
    if (density_.empty()) return 0.0f;
    float cosine = abs(dot(ray.direction, surface.geometricNormal));
    return cosine > 0.0f ? density_[hit.triangle] * hit.distance * hit.distance / cosine : 0.0f;
}
}
