// A level in GPU memory, as shaders/scene.h lays it out: buffers of scalar layout, textures with mips, and what is drawn, in what ranges.
#pragma once
#include "engine/baked/baked.hpp"
#include "engine/upload/acceleration.hpp"
#include <span>
#include <vector>

namespace afterglow
{
// How a draw meets the picture: in this order, each in its own pass.
enum class DrawKind {
    opaque,
    masked, // alpha >= cutoff keeps
    clear   // alpha blended or transmissive: drawn over the lit picture, far to near
};

// A coarser level of detail of a draw: other indices into the same vertices.
struct CoarserLevel {
    uint firstIndex = 0;
    uint indexCount = 0;
    float error = 0.0f; // how far it strays, m in the object's own space
    float turn = 0.0f;  // how its normals turn, radians
};

struct DrawItem {
    Instance instance;
    std::vector<CoarserLevel> coarser; // finest first; empty: none is to be drawn
    uint place = 0;                    // of it among instances(scene)
    vec3 lower, upper;                 // world bounds, m
    DrawKind kind = DrawKind::opaque;
    bool emits = false;
    bool roughMetal = false;
    float alpha = 1.0f;            // of its narrowest lobe (shaders/microfacet.h), where it has levels of detail; 1: matte
    bool closed = false;           // opaque, and its fronts hide its backs from every eye outside; once findClosedBodies() has looked
    vec3 objectLower, objectUpper; // bounds in its own space, m
    mat4x3 before{1.0f};           // object to world in the last frame
    bool moved = false;            // since the last frame
};

struct GpuScene {
    GpuBuffer vertices, indices, materials, lights, media, mediumPlanes; // absent when the level has none
    std::vector<GpuImage> textures;
    std::vector<SceneTexture> textureSamplers; // how each repeats and filters; no texels
    GpuImage skyImage;                         // absent: uniform
    GpuImage layerRatio, layerMean;            // shaders/layer.h; absent when every material is matte
    GpuRays rays;                              // absent unless something traces rays: the caller says so by buildRays()

    std::vector<DrawItem> draws;
    std::vector<Light> runtimeLights; // what `lights` holds
    vec3 lower{0.0f}, upper{0.0f};    // of everything drawn

    bool mediumEmits = false; // some medium sends out light by itself

    uint mediumCount() const { return uint(media.bytes / sizeof(Medium)); }
};

// Which draws are closed bodies (engine/scene/closed.hpp): each mesh is judged once, and only where something is rasterised.
void findClosedBodies(GpuScene& uploaded, const Scene& scene);

// Puts every draw of an object elsewhere; `toWorld` does not mirror. Where they were is remembered until settle().
void move(GpuScene& scene, uint object, const mat4& toWorld);
void settle(GpuScene& scene); // the frame is over: what is drawn rests until it is moved again

// Alpha blended or transmissive: light passes.
bool isClear(const Material& material);

// Lights whose direct part the bake does not hold: with none baked, all of them.
std::vector<Light> runtimeLights(const Scene& scene, bool baked, bool directAll);

// `placed`: instances(scene), with their places in the lightmap if there is one. `lods`: of each mesh, or none.
GpuScene uploadScene(Gpu& gpu, const Scene& scene, const std::vector<Instance>& placed, const std::vector<Light>& lights,
                     std::span<const MeshLods> lods = {});
}
