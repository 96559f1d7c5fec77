// A level in memory: what glTF said, with everything degenerate, non-finite or out of range already dropped or clamped, and counted.
// "World" is the level's own space seen from `origin`: engine/scene/origin.hpp.
#pragma once
#include "engine/core/image.hpp"
#include "shaders/scene.h"
#include "shaders/tones.h"
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace afterglow
{
using namespace shared;

// 8-bit texture as the file stores it; `srgb` says how the shader must read rgb (alpha is always linear).
enum class Wrap { repeat, mirror, clamp };
struct SceneTexture {
    std::string name;
    Image8 image; // RGBA
    bool srgb = false;
    Wrap wrapU = Wrap::repeat, wrapV = Wrap::repeat;
    bool nearest = false;
};

struct Sky {
    vec3 radiance{0.0f};   // uniform; tint of the image when there is one (then 1)
    Image image;           // equirectangular radiance, empty: uniform. Row 0 is +Y; column 0 looks along -x ... see shaders/light.h
    float rotation = 0.0f; // radians about +Y
};

struct Camera {
    std::string name;
    mat4 toWorld{1.0f};    // looks along its -z
    float fovY = 0.8f;     // radians; 0: orthographic
    float orthoHeight = 1; // m, whole height, when orthographic
    float nearPlane = 0.05f;
};
constexpr ivec2 kPictureSize{1280, 720}; // pixels of every picture, drawn or path traced, unless somebody asks for others

// One glTF primitive: ranges of the level's vertices and indices. Triangles only, counter-clockwise seen from the front.
struct Primitive {
    uint firstVertex, vertexCount, firstIndex, indexCount, material;
};
struct Mesh {
    std::string name;
    std::vector<Primitive> primitives;
};

// A mesh placed by a node. The node's name, and what its extras say. `toWorld` is invertible and never mirrors: a mesh that the level
// mirrors is reflected in its own vertices at import, so winding, normals and tangents agree in object space and in the world.
struct Object {
    std::string name;
    int node = -1; // index in the glTF file
    uint mesh = 0;
    dmat4 toWorld{1.0};
    bool isStatic = true;        // ag_static
    float texelsPerMetre = 0.0f; // ag_texels_per_metre, 0: the bake's
    bool mirror = false;         // ag_mirror
    std::string portal;          // ag_portal: name of the node behind it, empty: none
};

// A light that says ag_kelvin: its spectrum is its tint times planck().
struct HotLight {
    float temperature; // K
    vec3 tint;         // Rec.709, over the luminance of planck()
};

// Asked for by hand (ag_probe_volume, ag_reflection_probe on an empty node).
struct ProbeVolumeRequest {
    std::string name;
    mat4 toWorld{1.0f};   // the unit cube [-1/2, 1/2]^3 to the world
    float spacing = 1.0f; // m
};
struct ReflectionProbeRequest {
    std::string name;
    vec3 position{0.0f};
    vec3 halfExtents{1.0f}; // m, of the proxy box
};

enum class ToneCurve { none, reinhard, aces, hable };

struct Display {
    std::optional<float> exposureEv; // ag_exposure_ev; absent: chosen from the picture
    ToneCurve curve = ToneCurve::aces;
    float bloom = 0.0f; // ag_bloom
    bool toon = false;
    int toonSteps = 3;
    std::vector<ToonStep> toonRamp; // ag_toon_ramp and ag_toon_edges; empty: steps of equal width
    float outlinePixels = 0.0f;
    vec3 outlineColor{0.0f};            // ag_outline_color: radiance
    std::optional<float> outlineCrease; // ag_outline_crease_deg, in radians
};

struct Scene {
    std::filesystem::path path; // the level's file
    dvec3 origin{0.0};          // m, in the level's own coordinates: where the world's 0 lies; 0 unless the level is far out
    std::vector<Vertex> vertices;
    std::vector<uint> indices; // relative to the primitive's firstVertex
    std::vector<Material> materials;
    std::vector<std::string> materialNames;
    std::map<uint, std::vector<ToonStep>> toonRamps; // of materials that say ag_toon_ramp: by index
    std::vector<SceneTexture> textures;
    std::vector<Mesh> meshes;
    std::vector<Object> objects;
    std::vector<Light> lights; // world space
    std::vector<std::string> lightNames;
    std::map<uint, HotLight> hotLights; // by index of the light
    std::vector<Camera> cameras;
    std::vector<Medium> media;      // the level's first, when it has one
    std::vector<vec4> mediumPlanes; // of all media that are no boxes along the axes (Medium::firstPlane)
    Sky sky;
    Display display;
    std::vector<ProbeVolumeRequest> probeVolumes;
    std::vector<ReflectionProbeRequest> reflectionProbes;
    std::map<std::string, int> dropped; // "degenerate triangles" -> count: what import dropped or clamped, and why
    std::vector<std::string> warnings;

    vec3 lower{0.0f}, upper{0.0f}; // world bounds of the static geometry (of all of it when none is static), m; 0 when empty
};

// Reads .glb or .gltf. Throws Error (exit 3) with one sentence when the file is missing, is not glTF, is truncated, or points outside its
// own folder; everything milder is repaired, counted in `dropped` and told in `warnings`.
Scene loadLevel(const std::filesystem::path& path);

// All that loadLevel() reads: the level's file, and the buffers, images and sky that it names, there or not. Throws Error as that does.
std::vector<std::filesystem::path> filesOf(const std::filesystem::path& level);

// What import left out or clamped, in one line for a person; empty: nothing.
std::string droppedText(const Scene& scene);

// Every primitive of every object as a placed instance, in object order: the order of draw calls, of the TLAS, of the baker's triangles.
std::vector<Instance> instances(const Scene& scene);

// RGBA of a texel, linear; x and y are wrapped as the texture says.
vec4 texel(const SceneTexture& texture, int x, int y);

// The camera called `name`, or with that index; the first when empty; one that sees the whole level when it has none. Throws Error.
Camera findCamera(const Scene& scene, const std::string& nameOrIndex);

// View to clip space, reversed depth (shaders/camera.h). How high the camera sees is its own; how wide follows from the picture, in pixels:
// they are square, whatever the file says of an aspect. Throws Error when no picture can be made.
mat4 projection(const Camera& camera, uvec2 picture);
}
