// The level as rays meet it on the GPU, for shaders/trace.glsl: its triangles placed in the world, in an order that makes a good tree.
// Built only when something that the plan keeps traces rays, on a device that can.
#pragma once
#include "engine/gpu/acceleration_structure.hpp"
#include "engine/gpu/gpu.hpp"
#include "engine/scene/scene.hpp"

namespace afterglow
{
// A placed mesh that has a structure of its own.
struct RayMesh {
    Instance instance; // as it was when the structure was built, in the world
    uint number;       // of it among all instances
    std::size_t place; // of its structure in GpuRays::placed
};

struct GpuRays {
    std::vector<AccelerationStructure> structures; // of the placed meshes
    AccelerationStructure level;                   // all of them; absent: nothing to meet
    bool filtered = false, tinted = false;         // some triangle may let rays through, or tint them
    GpuBuffer triangles;                           // RayTriangle, as Hit::triangle counts them
    GpuBuffer instances;                           // Instance
    GpuBuffer meetingErrors;                       // float, m, by material: the largest meetingError() (shaders/ray.h) of its triangles
    GpuBuffer texels, textures;          // RGBA8; TexelRange. Absent unless paths ask for them, and where a device's buffers are too small
    std::vector<uint> order;             // of each triangle its number among all of `placed`, one instance after another
    std::vector<PlacedStructure> placed; // the structures as `level` holds them
    std::vector<RayMesh> meshes;
    explicit operator bool() const { return bool(level); }
};

enum class RaysFor {
    frame,
    paths // there is a structure even where nothing can be met, and textures are there texel by texel
};

// `placed`: as uploadScene takes them. Throws Error (exit 3) when the level has more triangles than the device's trees take.
GpuRays buildRays(Gpu& gpu, const Scene& scene, const std::vector<Instance>& placed, RaysFor purpose = RaysFor::frame);

// Puts an object elsewhere: its structures stay, the level's is built anew in its place, between frames. In a level of so many meshes that
// they share structures (acceleration.cpp), rays meet it where it was.
void move(Gpu& gpu, GpuRays& rays, uint object, const mat4& toWorld);
}
