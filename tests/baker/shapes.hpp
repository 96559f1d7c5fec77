// Small levels for the baker's tests, made here: boxes, spheres, tori, grids, and meshes that no half-edge structure likes.
#pragma once
#include "engine/scene/scene.hpp"
#include "shaders/constants.h"
#include <map>

namespace afterglow
{
struct Shape {
    std::vector<vec3> positions;
    std::vector<uint> indices;
};

const float kTurn = 2.0f * kPi; // radians

inline void append(Shape& to, const Shape& shape)
{
    uint first = uint(to.positions.size());
    to.positions.insert(to.positions.end(), shape.positions.begin(), shape.positions.end());
    for (uint i : shape.indices) to.indices.push_back(first + i);
}

inline Shape flipped(Shape shape)
{
    for (std::size_t i = 0; i < shape.indices.size(); i += 3) std::swap(shape.indices[i + 1], shape.indices[i + 2]);
    return shape;
}

inline Shape moved(Shape shape, vec3 by)
{
    for (vec3& p : shape.positions) p += by;
    return shape;
}

inline Shape box(vec3 size) // four vertices a face, as exporters write them
{
    Shape shape;
    for (int axis = 0; axis < 3; ++axis)
        for (float side : {-1.0f, 1.0f}) {
            vec3 normal(0.0f), u(0.0f), v(0.0f);
            normal[axis] = side;
            u[(axis + 1) % 3] = 1.0f;
            v[(axis + 2) % 3] = side;
            Shape face{{}, {0, 1, 2, 0, 2, 3}};
            for (vec2 c : {vec2(-1, -1), vec2(1, -1), vec2(1, 1), vec2(-1, 1)})
                face.positions.push_back(0.5f * size * (normal + c.x * u + c.y * v));
            append(shape, face);
        }
    return shape;
}

inline Shape icosphere(int level)
{
    const float g = (1.0f + std::sqrt(5.0f)) / 2.0f;
    Shape shape{{{-1, g, 0},
                 {1, g, 0},
                 {-1, -g, 0},
                 {1, -g, 0},
                 {0, -1, g},
                 {0, 1, g},
                 {0, -1, -g},
                 {0, 1, -g},
                 {g, 0, -1},
                 {g, 0, 1},
                 {-g, 0, -1},
                 {-g, 0, 1}},
                {0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4,  11, 10, 2,  10, 7, 6, 7, 1, 8,
                 3, 9,  4, 3, 4, 2, 3, 2, 6, 3, 6, 8,  3, 8,  9,  4, 9, 5, 2, 4,  11, 6,  2,  10, 8,  6, 7, 9, 8, 1}};
    for (vec3& p : shape.positions) p = normalize(p);
    for (int i = 0; i < level; ++i) {
        std::map<std::pair<uint, uint>, uint> middles;
        auto middle = [&](uint a, uint b) {
            auto [entry, isNew] = middles.try_emplace({min(a, b), max(a, b)}, uint(shape.positions.size()));
            if (isNew) shape.positions.push_back(normalize(shape.positions[a] + shape.positions[b]));
            return entry->second;
        };
        std::vector<uint> finer;
        for (std::size_t t = 0; t < shape.indices.size(); t += 3) {
            uint a = shape.indices[t], b = shape.indices[t + 1], c = shape.indices[t + 2];
            uint ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            for (uint v : {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca}) finer.push_back(v);
        }
        shape.indices = finer;
    }
    return shape;
}

inline Shape bumpySphere(int level)
{
    Shape shape = icosphere(level);
    for (vec3& p : shape.positions) p *= 1.0f + 0.08f * std::sin(9.0f * p.x) * std::sin(11.0f * p.y + 1.0f) * std::sin(7.0f * p.z + 2.0f);
    return shape;
}

// n x m quads over the unit square of (u, v), placed by `at`.
template <typename At>
Shape grid(uint n, uint m, At at)
{
    Shape shape;
    for (uint j = 0; j <= m; ++j)
        for (uint i = 0; i <= n; ++i) shape.positions.push_back(at(float(i) / float(n), float(j) / float(m)));
    for (uint j = 0; j < m; ++j)
        for (uint i = 0; i < n; ++i) {
            uint a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
            for (uint v : {a, b, d, a, d, c}) shape.indices.push_back(v);
        }
    return shape;
}

inline Shape torus(float large, float small, uint n, uint m) // closed: the vertices of its seams are doubled
{
    auto angle = [](float u) { return u == 1.0f ? 0.0f : u * kTurn; };
    return grid(n, m, [=](float u, float v) {
        float a = angle(u), b = angle(v), r = large + small * std::cos(b);
        return vec3(r * std::cos(a), small * std::sin(b), -r * std::sin(a));
    });
}

// A ramp that winds `turns` times about the y axis: its plan view covers the same ring again and again.
inline Shape spiralRamp(float turns)
{
    return grid(uint(32 * turns), 1, [=](float u, float v) {
        float a = u * turns * kTurn, r = 2.0f + v;
        return vec3(r * std::cos(a), turns * u, r * std::sin(a));
    });
}

// `count` squares that share one side on the y axis: an edge of as many faces.
inline Shape fins(uint count)
{
    Shape shape;
    for (uint i = 0; i < count; ++i) {
        float a = kTurn * float(i) / float(count);
        vec3 out(std::cos(a), 0, std::sin(a)), up(0, 1, 0);
        append(shape, {{vec3(0), out, out + up, up}, {0, 1, 2, 0, 2, 3}});
    }
    return shape;
}

inline uint addMesh(Scene& scene, const Shape& shape)
{
    Primitive primitive{uint(scene.vertices.size()), uint(shape.positions.size()), uint(scene.indices.size()), uint(shape.indices.size()),
                        0};
    for (const vec3& p : shape.positions) scene.vertices.push_back({.position = p, .normal = vec3(0, 1, 0)});
    scene.indices.insert(scene.indices.end(), shape.indices.begin(), shape.indices.end());
    scene.meshes.push_back({"mesh" + std::to_string(scene.meshes.size()), {primitive}});
    return uint(scene.meshes.size() - 1);
}

inline Object& addObject(Scene& scene, uint mesh, dmat4 toWorld = dmat4(1.0))
{
    Object object;
    object.name = "object" + std::to_string(scene.objects.size());
    object.mesh = mesh;
    object.toWorld = toWorld;
    scene.objects.push_back(object);
    return scene.objects.back();
}

inline Scene levelOf(const Shape& shape)
{
    Scene scene;
    addObject(scene, addMesh(scene, shape));
    return scene;
}

// A square of 2 * half m about `middle` whose front looks up, or down.
inline Shape plate(vec3 middle, float half, bool up = true)
{
    Shape shape{{{-half, 0, -half}, {-half, 0, half}, {half, 0, half}, {half, 0, -half}}, {0, 1, 2, 0, 2, 3}};
    return moved(up ? shape : flipped(shape), middle);
}

// Lambert, without textures.
inline Material matte(float albedo)
{
    Material m{};
    m.baseColor = vec4(albedo, albedo, albedo, 1.0f);
    m.roughness = 1.0f;
    m.ior = 1.5f;
    m.flags = kMaterialLambert;
    m.baseColorTexture.texture = m.metallicRoughnessTexture.texture = m.normalTexture.texture = m.emissiveTexture.texture =
        m.transmissionTexture.texture = -1;
    return m;
}

// An object of its own, with its own material.
inline void add(Scene& scene, const Shape& shape, const Material& material)
{
    uint mesh = addMesh(scene, shape);
    uint first = scene.meshes[mesh].primitives[0].firstVertex;
    for (uint i = first; i < scene.vertices.size(); i++) {
        scene.vertices[i].tangent = vec4(1.0f, 0.0f, 0.0f, 1.0f);
        scene.vertices[i].color = ~0u;
    }
    for (std::size_t i = 0; i + 2 < shape.indices.size(); i += 3) {
        const vec3* p[3];
        for (std::size_t k = 0; k < 3; k++) p[k] = &shape.positions[shape.indices[i + k]];
        vec3 normal = normalize(cross(*p[1] - *p[0], *p[2] - *p[0]));
        for (std::size_t k = 0; k < 3; k++) scene.vertices[first + shape.indices[i + k]].normal = normal;
    }
    scene.meshes[mesh].primitives[0].material = uint(scene.materials.size());
    scene.materials.push_back(material);
    addObject(scene, mesh);
}
}
