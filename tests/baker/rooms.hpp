// Closed boxes about the origin whose faces shine as they are told, seen from inside.
#pragma once
#include "baker/lightmap.hpp"
#include "shapes.hpp"
#include "tests/shaders/statistics.hpp"

namespace afterglow
{
inline Material shining(float radiance, float albedo = 0.0f)
{
    Material material{};
    material.baseColor = vec4(vec3(albedo), 1.0f);
    material.emission = vec3(radiance);
    material.flags = kMaterialLambert;
    for (TextureRef* none : {&material.baseColorTexture, &material.metallicRoughnessTexture, &material.normalTexture,
                             &material.emissiveTexture, &material.transmissionTexture})
        none->texture = -1;
    return material;
}

inline void addSurface(Scene& scene, const Shape& shape, const Material& material)
{
    const uint mesh = addMesh(scene, shape);
    scene.meshes[mesh].primitives[0].material = uint(scene.materials.size());
    scene.materials.push_back(material);
    for (std::size_t i = 0; i < shape.indices.size(); i += 3) { // flat
        Vertex* v = &scene.vertices[scene.meshes[mesh].primitives[0].firstVertex];
        const vec3 normal = normalize(cross(v[shape.indices[i + 1]].position - v[shape.indices[i]].position,
                                            v[shape.indices[i + 2]].position - v[shape.indices[i]].position));
        for (std::size_t k = 0; k < 3; k++) {
            v[shape.indices[i + k]].normal = normal;
            v[shape.indices[i + k]].color = 0xffffffffu; // white
        }
    }
    addObject(scene, mesh);
}

// The triangles of a shape whose middle is where it is asked for.
template <typename Where>
Shape part(const Shape& shape, Where where)
{
    Shape result{shape.positions, {}};
    for (std::size_t i = 0; i < shape.indices.size(); i += 3) {
        const uint* t = &shape.indices[i];
        if (where((shape.positions[t[0]] + shape.positions[t[1]] + shape.positions[t[2]]) / 3.0f))
            result.indices.insert(result.indices.end(), t, t + 3);
    }
    return result;
}

inline constexpr vec3 kAxes[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

inline vec3 anywhere(test::Random& random, vec3 lower, vec3 upper)
{
    return lower + (upper - lower) * vec3(random.next(), random.next(), random.next());
}

// 2 m wide; the walls on the side of +x shine with radiance 1 and all are black: radiance is 1 from every direction with x > 0, else 0.
inline Scene halfLitRoom()
{
    const Shape half = flipped(box(vec3(1.0f, 2.0f, 2.0f)));
    const auto outer = [](float sign) { return [=](vec3 p) { return sign * p.x > 1e-3f; }; };
    Scene scene;
    addSurface(scene, part(moved(half, vec3(0.5f, 0, 0)), outer(1.0f)), shining(1.0f));
    addSurface(scene, part(moved(half, vec3(-0.5f, 0, 0)), outer(-1.0f)), shining(0.0f));
    scene.lower = vec3(-1.0f), scene.upper = vec3(1.0f);
    return scene;
}

// A furnace: every wall shines with 1 - albedo, so radiance is (1 - albedo) (1 + albedo + ...) = 1 everywhere.
inline Scene furnace(float albedo)
{
    Scene scene;
    addSurface(scene, flipped(box(vec3(2.0f))), shining(1.0f - albedo, albedo));
    scene.lower = vec3(-1.0f), scene.upper = vec3(1.0f);
    return scene;
}

// A scene with what a stage needs to work on it.
struct Bakery {
    Scene scene;
    World world{scene, Content::staticOnly};
    LightTransport transport{world, scene.lights};
    Progress silent{ProgressStyle::none};
    BakeContext context{transport, Solids(transport), {}, silent};
    explicit Bakery(Scene s) : scene(std::move(s)) {}
};
}
