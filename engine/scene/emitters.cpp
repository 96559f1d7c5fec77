#include "engine/scene/emitters.hpp"
#include "shaders/bsdf.h"
#include "shaders/color.h"
#include "shaders/ray_scene.h"
#include "shaders/texture_ref.h"
#include <algorithm>
#include <array>
#include <cmath>

namespace afterglow
{
namespace
{
using Corners = std::array<Vertex, 3>; // in the world

bool varies(const Material& m) { return m.emissiveTexture.texture >= 0 || (m.flags & (kMaterialAlphaMask | kMaterialAlphaBlend)) != 0; }

vec4 nearestTexel(const Scene& scene, const TextureRef& ref, vec2 uv0, vec2 uv1)
{
    if (ref.texture < 0) return vec4(1.0f);
    const SceneTexture& texture = scene.textures[std::size_t(ref.texture)];
    if (texture.image.width == 0) return vec4(1.0f);
    const vec2 uv = clamp(textureUv(ref, uv0, uv1), vec2(-1e4f), vec2(1e4f)); // the integer part stays an int
    return texel(texture, int(std::floor(uv.x * float(texture.image.width))), int(std::floor(uv.y * float(texture.image.height))));
}

// Mean emission over a triangle, from the nearest texels of a few points: it only steers the choice, so it need not be exact, but never 0
// where light leaves.
float meanEmission(const Scene& scene, const Material& m, const Corners& v)
{
    const float factor = luminance(m.emission);
    if (!varies(m)) return factor;
    float sum = 0.0f;
    for (const vec2 p :
         {vec2(1.0f / 3.0f), vec2(0.1f, 0.1f), vec2(0.8f, 0.1f), vec2(0.1f, 0.8f), vec2(0.45f, 0.1f), vec2(0.1f, 0.45f), vec2(0.45f)}) {
        const vec3 b(1.0f - p.x - p.y, p.x, p.y);
        const vec2 uv0 = b.x * v[0].uv0 + b.y * v[1].uv0 + b.z * v[2].uv0, uv1 = b.x * v[0].uv1 + b.y * v[1].uv1 + b.z * v[2].uv1;
        const float alpha = dot(b, vec3(unpackUnorm4x8(v[0].color).w, unpackUnorm4x8(v[1].color).w, unpackUnorm4x8(v[2].color).w));
        const vec3 emission = m.emission * vec3(nearestTexel(scene, m.emissiveTexture, uv0, uv1));
        sum += luminance(emission) * metShare(m, m.baseColor.w * alpha * nearestTexel(scene, m.baseColorTexture, uv0, uv1).w);
    }
    return std::max(sum / 7.0f, 0.02f * factor);
}

// Where a choice starts looking.
void fillGuides(std::vector<Emitter>& emitters)
{
    uint first = 0;
    for (std::size_t i = 0; i < emitters.size(); i++) {
        while (!(emitters[first].upTo > float(i) / float(emitters.size()))) first++;
        emitters[i].guide = first;
    }
}
}

EmitterTable emitterTable(const Scene& scene, const std::vector<Instance>& placed, const std::vector<uint>& order)
{
    std::vector<uint> tracers(order.size()); // by number of the level: the tracer's
    for (uint i = 0; i < order.size(); i++) tracers[order[i]] = i;

    EmitterTable table;
    std::vector<double> power;
    double total = 0.0;
    uint number = 0; // of the instance's first triangle
    for (const Instance& instance : placed) {
        const Material& material = scene.materials[instance.material];
        const uint triangles = instance.indexCount / 3, first = number;
        number += triangles;
        if (!(largestOf(material.emission) > 0.0f)) continue;
        for (uint t = 0; t < triangles; t++) {
            Corners v;
            for (uint c = 0; c < 3; c++)
                v[c] = placedVertex(instance, scene.vertices[instance.firstVertex + scene.indices[instance.firstIndex + 3 * t + c]]);
            Emitter emitter{};
            emitter.triangle = tracers[first + t];
            emitter.corner = v[0].position;
            emitter.edge1 = v[1].position - v[0].position;
            emitter.edge2 = v[2].position - v[0].position;
            emitter.normal = cross(emitter.edge1, emitter.edge2); // twice the area, until the densities are known
            emitter.emission = material.emission;
            emitter.flags =
                (varies(material) ? kEmitterVaries : 0u) | ((material.flags & kMaterialDoubleSided) != 0 ? kEmitterBothSides : 0u);
            const double mine = double(meanEmission(scene, material, v)) * double(length(emitter.normal));
            if (!(mine > 0.0)) continue;
            table.emitters.push_back(emitter);
            power.push_back(mine);
            total += mine;
        }
    }
    if (table.emitters.empty()) return table;
    table.density.assign(order.size(), 0.0f);
    double sum = 0.0;
    for (std::size_t i = 0; i < power.size(); i++) {
        Emitter& emitter = table.emitters[i];
        sum += power[i];
        emitter.upTo = float(sum / total);
        const float area = 0.5f * length(emitter.normal);
        emitter.normal = normalize(emitter.normal);
        emitter.density = table.density[emitter.triangle] = float(power[i] / total / double(area));
    }
    table.emitters.back().upTo = 1.0f;
    fillGuides(table.emitters);
    return table;
}
}
