#include "baker/cube.hpp"
#include <algorithm>

namespace afterglow
{
// A texel of a face, or, up to one step beyond its edge, that of the face which is met there.
static vec3 texelAt(const vec3* faces, int size, int face, ivec2 at)
{
    const ivec2 inside = clamp(at, ivec2(0), ivec2(size - 1));
    if (at != inside) {
        if (at.x != inside.x && at.y != inside.y)
            return (texelAt(faces, size, face, inside) + texelAt(faces, size, face, ivec2(at.x, inside.y)) +
                    texelAt(faces, size, face, ivec2(inside.x, at.y))) /
                   3.0f;
        const vec3 met = cubeFace(cubeDirection(face, (vec2(at) + 0.5f) / float(size)));
        face = int(met.z);
        at = clamp(ivec2(vec2(met) * float(size)), ivec2(0), ivec2(size - 1));
    }
    return faces[(face * size + at.y) * size + at.x];
}

vec3 cubeRadiance(const std::vector<vec3>& faces, int size, vec3 direction)
{
    const vec3 at = cubeFace(direction);
    const vec2 p = vec2(at) * float(size) - 0.5f;
    const ivec2 a(floor(p)), b = a + 1;
    const vec2 f = p - vec2(a);
    const auto texel = [&](int x, int y) { return texelAt(faces.data(), size, int(at.z), ivec2(x, y)); };
    return mix(mix(texel(a.x, a.y), texel(b.x, a.y), f.x), mix(texel(a.x, b.y), texel(b.x, b.y), f.x), f.y);
}

vec3 cubeRadiance(const ReflectionProbe& probe, vec3 direction, float roughness)
{
    const float mip = reflectionMip(roughness, float(probe.mips.size()));
    const int fine = int(mip), coarse = std::min(fine + 1, int(probe.mips.size()) - 1);
    return mix(cubeRadiance(probe.mips[std::size_t(fine)], probe.size >> fine, direction),
               cubeRadiance(probe.mips[std::size_t(coarse)], probe.size >> coarse, direction), mip - float(fine));
}

ReflectionBox boxOf(const ReflectionProbe& probe) { return {probe.position, float(probe.mips.size()), probe.boxLower, probe.boxUpper}; }

vec3 reflectedRadiance(std::span<const ReflectionProbe> probes, vec3 position, vec3 r, float roughness, vec3 fallback)
{
    vec3 sum(0.0f);
    float weights = 0.0f, covered = 0.0f;
    for (const ReflectionProbe& probe : probes) {
        const ReflectionBox box = boxOf(probe);
        const vec2 influence = reflectionInfluence(box, position);
        if (!(influence.x > 0.0f)) continue;
        sum += influence.y * cubeRadiance(probe, reflectionDirection(box, position, r), roughness);
        weights += influence.y;
        covered = max(covered, influence.x);
    }
    return weights > 0.0f ? mix(fallback, sum / weights, covered) : fallback;
}
}
