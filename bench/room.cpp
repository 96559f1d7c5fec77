// A room of the size, the colours and the contents that Blender's Cycles was once measured with, and the time that its lightmap takes to be 2 % off:
// ours, with the filter and without, and Cycles' on the same mesh and the same texels, where this machine has Blender.
#include "bench/child.hpp"
#include "bench/cycles.hpp"
#include "bench/noise.hpp"
#include "shaders/constants.h"
#include "shaders/frame.h"
#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

constexpr double kWanted = 0.02;              // relative RMSE of a texel
constexpr double kTexels = 48076.0;           // baked ones of Cycles' page of 256 x 256
constexpr float kPower = 40.0f, kLamp = 0.5f; // W, and m of its edge

static const vec3 kWhite(0.73f), kRed(0.63f, 0.065f, 0.05f), kGreen(0.14f, 0.45f, 0.091f);

static uint addMaterial(Scene& scene, vec3 albedo, vec3 emission = vec3(0.0f))
{
    Material material{};
    material.baseColor = vec4(albedo, 1.0f);
    material.emission = emission;
    material.flags = kMaterialLambert;
    for (TextureRef* none : {&material.baseColorTexture, &material.metallicRoughnessTexture, &material.normalTexture,
                             &material.emissiveTexture, &material.transmissionTexture})
        none->texture = -1;
    scene.materials.push_back(material);
    return uint(scene.materials.size() - 1);
}

using At = std::function<vec3(float u, float v)>;

// n x m quads over the unit square, flat ones; `at` in metres with z up, its front where u turns to v by the left.
static void addSheet(Scene& scene, uint n, uint m, uint material, const At& at)
{
    const auto first = uint(scene.vertices.size()), firstIndex = uint(scene.indices.size());
    const auto yUp = [&](uint i, uint j) {
        const vec3 p = at(i == n ? 0.999999f : float(i) / float(n), float(j) / float(m));
        return vec3(p.x, p.z, -p.y);
    };
    for (uint j = 0; j < m; ++j)
        for (uint i = 0; i < n; ++i) {
            const vec3 corner[4] = {yUp(i, j), yUp(i + 1, j), yUp(i + 1, j + 1), yUp(i, j + 1)};
            const vec3 normal = safeNormalize(cross(corner[2] - corner[0], corner[3] - corner[1]), vec3(0.0f, 1.0f, 0.0f));
            const uint base = uint(scene.vertices.size()) - first;
            for (const vec3& c : corner) scene.vertices.push_back({.position = c, .normal = normal, .color = 0xffffffffu});
            for (const uint second : {1u, 2u}) // without the one that a pole leaves no area
                if (length(cross(corner[second] - corner[0], corner[second + 1] - corner[0])) > 1e-9f)
                    for (const uint k : {0u, second, second + 1}) scene.indices.push_back(base + k);
        }
    Object object;
    object.mesh = uint(scene.meshes.size());
    const uint vertices = uint(scene.vertices.size()) - first, indices = uint(scene.indices.size()) - firstIndex;
    scene.meshes.push_back({"", {{first, vertices, firstIndex, indices, material}}});
    scene.objects.push_back(object);
}

static void addQuad(Scene& scene, uint material, vec3 corner, vec3 u, vec3 v)
{
    addSheet(scene, 1, 1, material, [=](float s, float t) { return corner + std::round(s) * u + t * v; });
}

// Turned about z, in radians.
static void addBox(Scene& scene, uint material, vec3 middle, vec3 size, float turn)
{
    const vec3 x = size.x * vec3(std::cos(turn), std::sin(turn), 0.0f), y = size.y * vec3(-std::sin(turn), std::cos(turn), 0.0f),
               z = vec3(0.0f, 0.0f, size.z);
    const vec3 low = middle - 0.5f * (x + y + z), high = middle + 0.5f * (x + y + z);
    addQuad(scene, material, low, y, x), addQuad(scene, material, low, x, z), addQuad(scene, material, low, z, y);
    addQuad(scene, material, high, -x, -y), addQuad(scene, material, high, -z, -x), addQuad(scene, material, high, -y, -z);
}

// An open box of 2 m; in it two boxes, a ball on one of them, a ring, and a lamp under the ceiling.
static Scene room()
{
    Scene scene;
    const uint white = addMaterial(scene, kWhite), red = addMaterial(scene, kRed), green = addMaterial(scene, kGreen);
    const uint lamp = addMaterial(scene, vec3(0.0f), vec3(kPower / (kPi * kLamp * kLamp)));
    const vec3 x(2.0f, 0.0f, 0.0f), y(0.0f, 2.0f, 0.0f), z(0.0f, 0.0f, 2.0f);
    addQuad(scene, white, vec3(-1.0f, -1.0f, 0.0f), x, y);
    addQuad(scene, white, vec3(-1.0f, -1.0f, 2.0f), y, x);
    addQuad(scene, white, vec3(-1.0f, 1.0f, 0.0f), x, z);
    addQuad(scene, red, vec3(-1.0f, -1.0f, 0.0f), y, z);
    addQuad(scene, green, vec3(1.0f, -1.0f, 0.0f), z, y);
    addBox(scene, white, vec3(0.35f, -0.3f, 0.3f), vec3(0.6f), -0.3f);
    addBox(scene, white, vec3(-0.35f, 0.35f, 0.6f), vec3(0.56f, 0.56f, 1.2f), 0.3f);
    addSheet(scene, 48, 24, white, [](float u, float v) {
        const float a = 2.0f * kPi * u, b = kPi * v;
        return vec3(0.35f, -0.3f, 0.85f) + 0.25f * vec3(std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), -std::cos(b));
    });
    addSheet(scene, 48, 16, red, [](float u, float v) {
        const float a = 2.0f * kPi * u, b = 2.0f * kPi * v, r = 0.25f + 0.1f * std::cos(b);
        return vec3(-0.5f + r * std::cos(a), -0.55f + r * std::sin(a), 0.1f + 0.1f * std::sin(b));
    });
    addQuad(scene, lamp, vec3(-0.5f * kLamp, -0.5f * kLamp, 1.99f), 0.25f * y, 0.25f * x);
    scene.lower = vec3(-1.0f, 0.0f, -1.0f), scene.upper = vec3(1.0f, 2.0f, 1.0f);
    return scene;
}

// 1 2 3 4 5 6 7 8 9 ... 16 18 20 ...: the time to an error is known within an eighth.
static int nextCount(int samples) { return samples + std::max(int(std::bit_floor(uint(samples))) / 8, 1); }

static json measure(const BenchOptions& options, const std::filesystem::path& folder)
{
    const Scene scene = room();
    BakeOptions bake = lightmapsAlone(options);
    bake.bounces = kRoomBounces;
    bake.denoiser = Denoiser::none;
    // As many texels as Cycles baked
    bake.texelsPerMetre = 32.0f, bake.samples = 1;
    *bake.texelsPerMetre *= float(std::sqrt(kTexels / bakePages(scene, bake).texels));
    bake.samples.reset();
    bake.targetError = kWanted;
    const Reference truth = reference(scene, bake);

    json result = {{"wanted", kWanted}, {"texels", truth.bake.texels}};
    const BakedPages plain = bakePages(scene, bake);
    result["none"] = {
        {"samples", plain.samples}, {"seconds", plain.seconds}, {"cpu_seconds", plain.cpuSeconds}, {"error", errorOf(plain, truth)}};
    bake.targetError.reset();
    for (int samples = 1; samples <= 1024 && !result.contains("builtin"); samples = nextCount(samples)) {
        bake.samples = samples;
        json row = noiseRow(scene, bake, truth);
        if (row["builtin"]["error"] <= kWanted) result["builtin"] = row["builtin"], result["builtin"]["samples"] = samples;
        result["rows"].push_back(row);
    }
    result["cycles"] = benchCycles(scene, *bake.texelsPerMetre, options, folder);
    return result;
}

json benchRoom(const BenchOptions& options, const std::filesystem::path& folder)
{
    return inChild([&] { return measure(options, folder); });
}
}
