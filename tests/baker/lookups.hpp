// What lookups on the surfaces of a baked level read, as a sampler with bilinear filtering does: all that the tests of leaks and edges ask.
#pragma once
#include "baker/owners.hpp"
#include <array>

namespace afterglow
{
// A texel that a lookup touches.
struct Touched {
    std::size_t texel;
    float weight;
};

constexpr float kTouched = 1.0f / 512.0f; // of a lookup's weight: below it a sampler of eight bits rounds it to 0

constexpr float kIn = 1e-4f; // of a triangle, by which a point of its edge lies in it for sure: another begins there

inline std::array<Touched, 4> touchedBy(const Lightmap& page, vec2 at)
{
    const vec2 p = at - 0.5f, cell = floor(p), f = p - cell;
    std::array<Touched, 4> touched;
    for (int corner = 0; corner < 4; corner++) {
        const ivec2 step(corner & 1, corner >> 1), texel = clamp(ivec2(cell) + step, ivec2(0), ivec2(page.width, page.height) - 1);
        touched[std::size_t(corner)] = {std::size_t(texel.y * page.width + texel.x),
                                        (step.x ? f.x : 1.0f - f.x) * (step.y ? f.y : 1.0f - f.y)};
    }
    return touched;
}

inline vec3 readAt(const Lightmap& page, vec2 at)
{
    vec3 sum(0.0f);
    for (const Touched& touched : touchedBy(page, at)) sum += touched.weight * page.texels[touched.texel];
    return sum;
}

// A point of a surface, and where a lookup there goes.
struct LookedAt {
    vec3 position, front; // m; unit
    uint triangle;        // of the world
    const Lightmap& page;
    vec2 texel;
};

// Calls with points of all surfaces, corners and edges among them, up to `spacing` texels apart.
template <typename Visit>
void lookAround(const World& world, const Baked& baked, float spacing, Visit visit)
{
    for (uint t = 0; t < world.triangles().size(); t++) {
        const LightmapPlace& place = baked.places[world.triangles()[t].object];
        const Lightmap& page = baked.lightmaps[std::size_t(place.page)];
        vec3 at[3];
        vec2 texel[3];
        float longest = 0.0f;
        for (int i = 0; i < 3; i++) {
            const Vertex& v = world.vertices()[world.triangles()[t].vertex[i]];
            at[i] = v.position;
            texel[i] = (v.uv1 * place.scale + place.offset) * vec2(float(page.width), float(page.height));
        }
        for (int i = 0; i < 3; i++) longest = max(longest, distance(texel[i], texel[(i + 1) % 3]));
        const vec3 front = normalize(world.front(t));
        const int n = max(int(std::ceil(longest / spacing)), 1);
        for (int j = 0; j <= n; j++)
            for (int i = 0; i + j <= n; i++) {
                const vec2 b = vec2(float(i), float(j)) / float(n), in = mix(b, vec2(1.0f / 3.0f), kIn);
                const vec3 position = (1.0f - in.x - in.y) * at[0] + in.x * at[1] + in.y * at[2];
                visit(LookedAt{position, front, t, page, (1.0f - b.x - b.y) * texel[0] + b.x * texel[1] + b.y * texel[2]});
            }
    }
}
}
