// Levels of a few quads, written by hand, whose pictures can be worked out on paper.
#pragma once
#include "engine/baked/baked.hpp"

namespace afterglow
{
inline Material matte(vec3 albedo)
{
    Material m{};
    m.baseColor = vec4(albedo, 1.0f);
    m.roughness = 1.0f;
    m.ior = 1.5f;
    m.specular = 1.0f;
    m.specularColor = vec3(1.0f);
    m.attenuationColor = vec3(1.0f);
    m.alphaCutoff = 0.5f;
    m.normalScale = 1.0f;
    m.flags = kMaterialLambert;
    for (TextureRef* ref : {&m.baseColorTexture, &m.metallicRoughnessTexture, &m.normalTexture, &m.emissiveTexture, &m.transmissionTexture})
        *ref = {-1, 0u, vec4(1.0f, 0.0f, 0.0f, 1.0f), vec2(0.0f)};
    return m;
}

inline uint addMaterial(Scene& scene, const Material& material)
{
    scene.materials.push_back(material);
    scene.materialNames.push_back("material " + std::to_string(scene.materials.size()));
    return uint(scene.materials.size() - 1);
}

// A quad corner, corner + u, corner + u + v, corner + v, whose front is where u x v points; both uv run from 0 to 1 along u and v.
inline Object& addQuad(Scene& scene, vec3 corner, vec3 u, vec3 v, uint material)
{
    const uint first = uint(scene.vertices.size()), index = uint(scene.indices.size());
    const vec3 normal = normalize(cross(u, v));
    for (const vec2 uv : {vec2(0, 0), vec2(1, 0), vec2(1, 1), vec2(0, 1)})
        scene.vertices.push_back({corner + uv.x * u + uv.y * v, normal, vec4(normalize(u), 1.0f), uv, uv, 0xffffffffu});
    for (const uint i : {0u, 1u, 2u, 0u, 2u, 3u}) scene.indices.push_back(i);
    scene.meshes.push_back({"quad", {Primitive{first, 4, index, 6, material}}});
    Object object;
    object.name = "quad " + std::to_string(scene.objects.size());
    object.mesh = uint(scene.meshes.size() - 1);
    scene.objects.push_back(object);
    return scene.objects.back();
}

// The inside of a box.
inline void addRoom(Scene& scene, vec3 lower, vec3 upper, uint material)
{
    const vec3 s = upper - lower, x(s.x, 0, 0), y(0, s.y, 0), z(0, 0, s.z);
    addQuad(scene, lower, z, x, material);     // floor, front upwards
    addQuad(scene, lower + y, x, z, material); // ceiling
    addQuad(scene, lower, x, y, material);     // far wall at -z, front towards +z
    addQuad(scene, lower + z, y, x, material); // near wall
    addQuad(scene, lower, y, z, material);     // at -x
    addQuad(scene, lower + x, z, y, material); // at +x
}

inline Light pointLight(vec3 position, vec3 intensity)
{
    Light light{};
    light.type = kLightPoint;
    light.position = position;
    light.direction = vec3(0.0f, -1.0f, 0.0f);
    light.intensity = intensity;
    return light;
}

inline Light sunLight(vec3 direction, vec3 irradiance)
{
    Light light{};
    light.type = kLightDirectional;
    light.direction = normalize(direction);
    light.intensity = irradiance;
    return light;
}

inline void addLight(Scene& scene, const Light& light)
{
    scene.lights.push_back(light);
    scene.lightNames.push_back("light");
}

// Looks from `eye` at `target`; +y is up unless it looks along it.
inline Camera lookAt(vec3 eye, vec3 target, float fovY = 0.8f)
{
    const vec3 back = normalize(eye - target);
    const vec3 up = std::abs(back.y) > 0.99f ? vec3(0, 0, -1) : vec3(0, 1, 0);
    const vec3 right = normalize(cross(up, back));
    Camera camera;
    camera.fovY = fovY;
    camera.toWorld = mat4(vec4(right, 0), vec4(cross(back, right), 0), vec4(back, 0), vec4(eye, 1));
    return camera;
}

// A bake of the scene whose lightmap holds one value everywhere: a page of 8 x 8 for each object that is static.
inline Baked bakedEvenly(const Scene& scene, vec3 value)
{
    Baked baked;
    baked.scene = scene;
    baked.lightmaps.push_back({8, 8, std::vector<vec3>(64, value), std::vector<std::uint8_t>(64, 1)});
    for (const Object& object : scene.objects) {
        LightmapPlace place;
        place.page = object.isStatic ? 0 : -1;
        baked.places.push_back(place);
    }
    return baked;
}

// Eight probes at the corners of the box; every one holds irradiance / pi of `value` about every normal.
inline ProbeTree evenProbes(vec3 lower, vec3 upper, vec3 value)
{
    ProbeTree tree;
    Probe probe{shZero(), vec3(0.0f), vec3(0.0f)};
    probe.irradiance.c[0] = value / shBasis(0, vec3(0.0f));
    ProbeCell cell{lower, 1.0f / (upper - lower), {}};
    for (uint corner = 0; corner < 8; corner++) {
        cell.probe[corner] = corner;
        tree.probes.push_back(probe);
        tree.positions.push_back(mix(lower, upper, vec3(corner & 1, corner >> 1 & 1, corner >> 2)));
    }
    tree.cells.push_back(cell);
    tree.nodes.push_back({vec3(0.0f), 0.0f, ~0, ~0}); // all of space
    return tree;
}

// Another tree's cells and probes behind those that are there; the nodes are the test's.
inline void append(ProbeTree& to, const ProbeTree& more)
{
    for (ProbeCell cell : more.cells) {
        for (uint& probe : cell.probe) probe += uint(to.probes.size());
        to.cells.push_back(cell);
    }
    to.probes.insert(to.probes.end(), more.probes.begin(), more.probes.end());
    to.positions.insert(to.positions.end(), more.positions.begin(), more.positions.end());
}

// A cubemap of one colour at every roughness.
inline ReflectionProbe evenReflection(vec3 lower, vec3 upper, vec3 radiance)
{
    ReflectionProbe probe;
    probe.name = "even";
    probe.position = 0.5f * (lower + upper);
    probe.boxLower = lower;
    probe.boxUpper = upper;
    probe.size = 8;
    for (std::size_t edge = 8; edge > 0; edge /= 2) probe.mips.emplace_back(6 * edge * edge, radiance);
    return probe;
}
}
